#include "motion_server/device/simulated/SeatedBody.h"

#include <cmath>

namespace coherency {

Coord3 SeatedBody::neckBase(const Lean& lean) const {
  const TransformMatrix leaned =
      TransformMatrix::rotationZ(-lean.right) * TransformMatrix::rotationX(-lean.forward);
  return Coord3(0.0, rig_.seat_height, 0.0) + leaned.vector({0.0, rig_.trunk_length, 0.0});
}

TransformMatrix SeatedBody::shoulder(const Lean& lean) const {
  const Coord3 neck = neckBase(lean);
  TransformMatrix thorax = rotationBetween({0.0, 1.0, 0.0}, neck - Coord3(0.0, rig_.seat_height, 0.0));
  thorax.setOrigin(neck);
  return thorax * TransformMatrix::translation({rig_.shoulder_half_width, -rig_.shoulder_drop, 0.0});
}

Coord3 SeatedBody::headCentre(const Lean& lean, const YawPitchRoll& attitude) const {
  return neckBase(lean) + rotation(attitude).vector({0.0, rig_.neck_length, -rig_.neck_back});
}

YawPitchRoll SeatedBody::facing(const Coord3& point, const Lean& lean) const {
  const Coord3 d = point - headCentre(lean, {});
  return {std::atan2(-d.x, -d.z), std::atan2(d.y, std::hypot(d.x, d.z)), 0.0};
}

}  // namespace coherency
