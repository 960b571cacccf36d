#pragma once

#include "common/body/Rig.h"
#include "common/math/Rotation.h"
#include "common/math/TransformMatrix.h"

namespace coherency {

/// How far the trunk leans about the hips, radians.
struct Lean {
  double forward = 0.0;
  double right = 0.0;
};

/// Where a seated person's parts are when the trunk leans and the head turns on the neck; all in the body
/// frame. Agrees with posture(): the neck base found from the head it gives is the one it leaned to.
class SeatedBody {
 public:
  explicit SeatedBody(const Rig& rig) : rig_(rig) {}

  Coord3 neckBase(const Lean& lean) const;
  TransformMatrix shoulder(const Lean& lean) const;
  Coord3 headCentre(const Lean& lean, const YawPitchRoll& attitude) const;
  /// Yaw and pitch that point the head at `point`, from where the upright head on this trunk is.
  YawPitchRoll facing(const Coord3& point, const Lean& lean) const;
  const Rig& rig() const { return rig_; }

 private:
  Rig rig_;
};

}  // namespace coherency
