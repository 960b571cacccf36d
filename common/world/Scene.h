#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/body/VirtualHuman.h"
#include "common/world/WorldState.h"

namespace coherency {

/// A lamp that shines from a point with inverse-square falloff, or from everywhere above (`sky`).
struct Light {
  Coord3 position;               ///< m, world
  Coord3 colour{1.0, 1.0, 1.0};  ///< linear RGB
  double intensity = 1.0;        ///< irradiance at 1 m, in units of a white surface's full brightness
};

/// A world to be in: the root of the tree, with the virtual human as one of its members. Derive from it, hold
/// objects as data members, register them with addMember(), and add a line to the table in Scene.cpp.
class Scene : public VRObject {
 public:
  /// Throws std::domain_error where the rig is not valid.
  Scene(std::string name, const Rig& rig, HumanShown shown = HumanShown::Whole);

  VirtualHuman& human() { return human_; }
  const VirtualHuman& human() const { return human_; }
  const std::vector<Light>& lights() const { return lights_; }
  Coord3 skyLight() const { return sky_; }        ///< ambient light from above, linear RGB
  Coord3 groundLight() const { return ground_; }  ///< and from below
  const DriveArea& driveArea() const { return area_; }
  const BasePose& start() const { return start_; }
  /// Places worth reaching for, in world coordinates: what a simulated operator looks at and puts its hand
  /// to.
  const std::vector<Coord3>& targets() const { return targets_; }
  /// Where the base should be to reach them.
  const BasePose& workplace() const { return workplace_; }

  /// Brings the tree into the given state: the human is placed on its base and takes up the sample's posture.
  void apply(const WorldState& state, const MotionSample& sample);

 protected:
  void addLight(const Light& light) { lights_.push_back(light); }
  void setAmbient(const Coord3& sky, const Coord3& ground) { sky_ = sky, ground_ = ground; }
  void setDriveArea(const DriveArea& area) { area_ = area; }
  void setStart(const BasePose& start) { start_ = start; }
  void setWorkplace(const BasePose& workplace) { workplace_ = workplace; }
  void addTarget(const Coord3& target) { targets_.push_back(target); }

 private:
  VirtualHuman human_;
  std::vector<Light> lights_;
  Coord3 sky_{0.4, 0.4, 0.4};
  Coord3 ground_{0.2, 0.2, 0.2};
  DriveArea area_;
  BasePose start_;
  BasePose workplace_;
  std::vector<Coord3> targets_;
};

/// Names makeScene() knows.
std::vector<std::string> sceneNames();
/// Throws std::invalid_argument naming the scene and those there are.
std::unique_ptr<Scene> makeScene(std::string_view name, const Rig& rig);

}  // namespace coherency
