#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/math/Trigonometry.h"
#include "common/world/WorldModel.h"
#include "common/world/WorldState.h"

namespace coherency {

/// What is in a vehicle's way at one moment.
struct Surroundings {
  std::span<const SolidBox> solids = {};
  std::span<const DoorModel> doors = {};
  std::span<const std::int32_t> openings = {};  ///< of the doors; one that is open is in nobody's way
  const Vehicle* other = nullptr;  ///< the other vehicle, with its footprint; null where there is none
  const VehicleModel* other_model = nullptr;

  bool nothing() const { return solids.empty() && doors.empty() && other == nullptr; }
};

/// What the operator's left hand and feet ask for: -1..1 and 0..1 as the DOFs are.
struct DriveControls {
  double right = 0.0;
  double ahead = 0.0;
  double twist = 0.0;
  double brake = 0.0;
  double boost = 0.0;
};
/// DOFs that are not valid drive nothing: they read zero.
DriveControls driveControls(const MotionSample& sample);

/// Whether drive() can have led to these speeds, to a few of their units.
bool isWithinLimits(const Vehicle& vehicle, const DriveLimits& limits);

/// One period of driving. Where something is in the way the vehicle stays clear of it: its speed across is
/// lost, along it is kept (one slides). A vehicle that already stands in something is pushed out, in all
/// at no more than 2 m/s beyond the speed it drives with, and comes no deeper into it.
void drive(Vehicle& vehicle, const DriveControls& controls, std::int64_t period_ns, const VehicleModel& model,
           const Surroundings& surroundings);

/// Where a disc of the vehicle's footprint stands.
BasePose discCentre(const BasePose& base, const FootprintDisc& disc, const SineCosine& heading);

/// How deep the vehicle stands in the deepest thing, m; 0 where it stands in nothing. `owner` (may be null)
/// becomes that thing's.
double deepestContact(const BasePose& base, const VehicleModel& model, const Surroundings& surroundings,
                      std::string* owner);

}  // namespace coherency
