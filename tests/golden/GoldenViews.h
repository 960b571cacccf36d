#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/world/Scene.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/draw/Renderer.h"
#include "tests/golden/GoldenPicture.h"

namespace coherency::golden {

/// Of one eye's picture, pixels.
inline constexpr int kWidth = 320;
inline constexpr int kHeight = 240;
/// In full detail, so that no budget has a part in them: what that changes is seen in render/DetailTest.cpp.
inline constexpr RendererSettings kSettings{.detail_px = 0.0};

/// A moment of a shipped scene, seen through an eye or two.
struct GoldenView {
  std::string name;  ///< of its files
  std::string scene;
  Mode mode = Mode::Operator;
  EyeChoice eyes = EyeChoice::Mono;
  std::string hmd = "generic";
  std::optional<BasePose> master = std::nullopt;     ///< the operator's place, in place of the scene's start
  double doors = 0.0;                                ///< how far all are open, 0 to 1
  std::vector<std::pair<Dof, double>> posture = {};  ///< SI, from the neutral one
  bool holds = false;                                ///< the hand has the first block
  std::vector<double> camera = {};                   ///< x, y, z, yaw, pitch in place of an eye; m, degrees
};

const std::vector<GoldenView>& goldenViews();
/// Their scenes, each once.
std::vector<std::string> goldenScenes();

std::unique_ptr<Scene> makeScene(const std::string& name);
/// Brings the scene into the view's moment and draws it.
GoldenPicture draw(Renderer& renderer, Scene& scene, const GoldenView& view);

}  // namespace coherency::golden
