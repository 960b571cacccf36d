#include "motion_server/EncodingChoice.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "common/motion/CompactCode.h"

namespace coherency {
namespace {

constexpr double kNearM = 0.5;
constexpr double kPxPerDegree = 20.0;

}  // namespace

double compactHandMm(const Rig& rig) {
  const double from_wrist = rig.hand;
  const double from_elbow = rig.forearm + from_wrist;
  const double from_shoulder = rig.upper_arm + from_elbow;
  const auto swing = [](std::initializer_list<Dof> joints, double lever_m) {
    double sum = 0.0;
    for (const Dof joint : joints) sum += compactError(joint) * lever_m;
    return sum;
  };
  return 1e3 * (swing({Dof::ShoulderFlexion, Dof::ShoulderAbduction, Dof::ShoulderRotation}, from_shoulder) +
                swing({Dof::ElbowFlexion, Dof::ForearmRotation}, from_elbow) +
                swing({Dof::WristFlexion, Dof::WristDeviation}, from_wrist));
}

double compactViewPx() {
  const double turned =
      compactError(Dof::HeadYaw) + compactError(Dof::HeadPitch) + compactError(Dof::HeadRoll);
  const double moved = std::sqrt(3.0) * compactError(Dof::HeadX) / kNearM;
  return (turned + moved) * 180.0 / std::numbers::pi * kPxPerDegree;
}

EncodingChoice chooseEncoding(const ServerConfig& config) {
  if (config.encoding != "auto") return {config.encoding == "compact", config.encoding + ", as configured"};
  const double hand_mm = compactHandMm(config.rig);
  const double view_px = compactViewPx();
  const bool fits = hand_mm <= config.hand_mm && view_px <= config.view_px;
  return {fits, fmt::format(
                    "{}: the compact encoding moves the hand by {:.2f} mm and the view by {:.2f} px at most, "
                    "{} the budgets of {} mm and {} px",
                    fits ? "compact" : "exact", hand_mm, view_px, fits ? "within" : "beyond", config.hand_mm,
                    config.view_px)};
}

}  // namespace coherency
