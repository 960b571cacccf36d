#include "motion_server/device/simulated/Gaze.h"

#include <algorithm>
#include <cmath>

namespace coherency {

namespace {

constexpr double kYawShare = 0.85;  // of the gaze shift, that the head does
constexpr double kPitchShare = 0.8;
constexpr double kYawLimit = 1.3;  // rad, of a comfortable neck
constexpr double kPitchDown = -1.0;
constexpr double kPitchUp = 0.6;
constexpr double kShortest = 0.3;     // s
constexpr double kPerRadian = 0.45;   // s more for each radian
constexpr double kRollPerYaw = 0.06;  // the head tilts a little into its turns

}  // namespace

double Gaze::shift(const YawPitchRoll& wished, double time_s, Chance& chance) {
  const double yaw = std::clamp(kYawShare * wished.yaw, -kYawLimit, kYawLimit) + chance.between(-0.02, 0.02);
  const double pitch =
      std::clamp(kPitchShare * wished.pitch, kPitchDown, kPitchUp) + chance.between(-0.02, 0.02);
  const YawPitchRoll now = at(time_s);
  const double amplitude = std::hypot(yaw - now.yaw, pitch - now.pitch);
  const double duration = (kShortest + kPerRadian * amplitude) * chance.between(0.9, 1.15);
  yaw_ = yaw_.redirected(yaw, time_s, duration);
  pitch_ = pitch_.redirected(pitch, time_s, duration);
  roll_ = roll_.redirected(kRollPerYaw * yaw + chance.between(-0.02, 0.02), time_s, duration * 1.1);
  return duration;
}

YawPitchRoll Gaze::at(double time_s) const {
  return {yaw_.at(time_s).position, pitch_.at(time_s).position, roll_.at(time_s).position};
}

}  // namespace coherency
