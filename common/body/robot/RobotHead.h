#pragma once

#include <array>

#include "common/body/Machined.h"
#include "common/body/Posture.h"
#include "common/scene/Polygon.h"

namespace coherency {

/// Head with two cameras on a neck that pans, tilts and rolls about the neck's base. Both eyes lie inside the
/// convex camera housing and inside the cones of both lens hoods: the cameras see out as if nothing were
/// there (HeadShape.h). Body axes.
class RobotHead : public VRObject {
 public:
  explicit RobotHead(const Rig& rig);

  void setPosture(const Posture& posture);

 private:
  void buildNeck(const Rig& rig);
  void buildSkull(const Rig& rig);
  void buildCameras(const Rig& rig);

  VRObject pan_{"robot neck pan"};
  VRObject tilt_{"robot neck tilt"};
  VRObject head_{"robot head frame"};
  Turned pan_drum_;
  std::array<Milled, 2> cheeks_;
  Turned tilt_drum_;
  Turned roll_drum_;
  Turned post_;
  Milled skull_;
  Arc handle_;
  std::array<Turned, 2> ears_;
  Milled aerial_;
  Milled housing_;
  std::array<Turned, 2> hoods_;
  std::array<Polygon, 2> lenses_;
};

}  // namespace coherency
