#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/world/Scene.h"
#include "render_client/compile/BakeSettings.h"
#include "render_client/compile/Illumination.h"
#include "render_client/draw/EyeView.h"

namespace coherency {

inline constexpr int kPeerWidth = 640;
inline constexpr int kPeerHeight = 480;
inline constexpr int kPeerSamples = 4;
inline constexpr int kPathFrames = 120;

/// T_world_box of a box among `count` that all move, in a frame: on a lattice a metre wide they turn and bob.
TransformMatrix movingPose(std::size_t number, std::size_t count, int frame);

struct PeerWorldOptions {
  /// As readScene() takes it, or "moving:N": N boxes that all move in every frame, under four lamps.
  std::string name;
  std::string folder = "configs/scenes";
  /// About how many of a grid's boxes the eye has in view: it stands as far before the last row, looks out
  /// over it and rests. 0: it goes along the path.
  int in_view = 0;
  BakeSettings bake;

  void addTo(CLI::App& app);
};

/// A scene to compare by, and the way an eye takes through it.
class PeerWorld {
 public:
  /// Throws what readScene() and Scene throw.
  explicit PeerWorld(const PeerWorldOptions& options);
  ~PeerWorld();

  const VRObject& root() const { return *root_; }
  const Illumination& illumination() const { return illumination_; }
  bool moves() const { return !boxes_.empty(); }
  /// Sets the transforms of what moves, as movingPose() has them: nobody's business to compute in the time
  /// that is taken.
  void move(const std::vector<TransformMatrix>& poses);
  std::vector<TransformMatrix> poses(int frame) const;
  /// One eye's, of the generic profile.
  EyeView view(int frame) const;

 private:
  void makeBoxes(int count);
  void makeScene(const PeerWorldOptions& options);

  std::vector<std::unique_ptr<VRObject>> boxes_;
  std::unique_ptr<VRObject> root_;  ///< dies before what it holds
  Illumination illumination_;
  TransformMatrix t_world_start_;  ///< of the eye
  double way_ = 0.0;               ///< m, that the eye goes ahead and back
  bool rests_ = false;
};

}  // namespace coherency
