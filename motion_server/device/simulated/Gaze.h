#pragma once

#include "common/math/Rotation.h"
#include "motion_server/device/simulated/MinimumJerk.h"
#include "motion_server/device/simulated/Variation.h"

namespace coherency {

/// The head's part in looking about: each gaze shift is one minimum-jerk turn whose duration grows with its
/// amplitude (the "main sequence" of head movements, Guitton & Volle 1987); the eyes, which no master
/// measures, do the rest.
class Gaze {
 public:
  /// Turns the head towards the direction of `wished`; the head covers most of the way, as people's do.
  /// Returns the shift's duration in seconds.
  double shift(const YawPitchRoll& wished, double time_s, Chance& chance);
  YawPitchRoll at(double time_s) const;

 private:
  MinimumJerk yaw_;
  MinimumJerk pitch_;
  MinimumJerk roll_;
};

}  // namespace coherency
