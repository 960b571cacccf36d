#include "common/world/World.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/math/FixedPoint.h"
#include "common/math/Trigonometry.h"
#include "common/world/Blocks.h"
#include "common/world/Driving.h"
#include "common/world/Plan.h"

namespace coherency {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kOpensWithinNs = 7 * kSecond / 10;  // from closed to open
constexpr std::int64_t kClosesWithinNs = 8 * kSecond / 5;
constexpr double kStickMoved = 0.05;  // of its way: the task has begun

WorldModel checked(WorldModel&& model) {
  const auto atMost = [](std::size_t count, std::size_t most, const char* what) {
    if (count > most)
      throw std::invalid_argument("a world with " + std::to_string(count) + " " + what +
                                  "; there may be at most " + std::to_string(most));
  };
  atMost(model.doors.size(), kMaxDoors, "doors");
  atMost(model.movables.size(), kMaxMovables, "things that can be grasped");
  return std::move(model);
}

/// Who drives along past it does not mean it: feet that point at it come nearer.
bool somebodyBefore(const DoorModel& door, const BasePose& base, const VehicleModel& vehicle) {
  const SineCosine heading = sineCosine(radiansFromUnits(base.heading_units));
  return std::any_of(vehicle.footprint.begin(), vehicle.footprint.end(), [&](const FootprintDisc& disc) {
    return length(between(discCentre(base, disc, heading), door.barrier.centre)) < door.sensor;
  });
}

void stepTask(TaskClock& task, const WorldState& state, const WorldModel& model,
              const DriveControls& controls, bool blocks_moved) {
  const double moved =
      std::max({std::abs(controls.right), std::abs(controls.ahead), std::abs(controls.twist)});
  if (task.started_tick == 0 && moved > kStickMoved) task.started_tick = state.tick;
  if (!blocks_moved) return;
  const bool stands = towerStands(state, model);
  if (stands && !task.standing) {
    task.done_tick = state.tick;
    ++task.towers;
  }
  task.standing = stands;
}

}  // namespace

World::World(WorldModel model)
    : model_(checked(std::move(model))), hand_(model_.master, Holder::OperatorHand) {
  if (model_.robot) robot_hand_.emplace(*model_.robot, Holder::RobotHand);
}

WorldState World::initialState() const {
  WorldState state;
  state.master.base = model_.master.start;
  if (model_.robot) state.robot.base = model_.robot->start;
  for (const MovableModel& m : model_.movables) {
    Movable movable;
    movable.x_nm = m.start.x_nm;
    movable.y_nm = m.start.y_nm;
    movable.z_nm = m.start.z_nm;
    setAttitude(movable, quaternion(TransformMatrix::rotationY(radiansFromUnits(m.start.heading_units))));
    movable.resting = false;  // its first steps find out what it stands on
    state.movables.push_back(movable);
  }
  state.doors.resize(model_.doors.size(), 0);
  return state;
}

bool World::hasPartsOf(const WorldState& state) const {
  const bool robot_needed = state.mode == Mode::Robot || (state.closed_hands & 2) != 0 ||
                            std::any_of(state.movables.begin(), state.movables.end(),
                                        [](const Movable& m) { return m.holder == Holder::RobotHand; });
  return state.movables.size() == model_.movables.size() && state.doors.size() == model_.doors.size() &&
         (model_.robot || !robot_needed);
}

bool World::fits(const WorldState& state) const {
  return isValid(state) && hasPartsOf(state) && isWithinLimits(state.master, model_.master.limits) &&
         (!model_.robot || isWithinLimits(state.robot, model_.robot->limits));
}

void World::step(WorldState& state, const MotionSample& sample, std::int64_t period_ns) const {
  if (!hasPartsOf(state))
    throw std::invalid_argument(
        "a state of another world: it has " + std::to_string(state.movables.size()) +
        " things to grasp and " + std::to_string(state.doors.size()) + " doors, or a robot, and this world " +
        std::to_string(model_.movables.size()) + " and " + std::to_string(model_.doors.size()) +
        (model_.robot ? ", with a robot" : ", without a robot"));
  ++state.tick;
  if (model_.driving) stepVehicles(state, sample, period_ns);
  if (!model_.doors.empty()) stepDoors(state, period_ns);
  bool changed = hand_.step(state, sample, state.master.base);
  if (robot_hand_) changed = robot_hand_->step(state, sample, state.robot.base) || changed;
  if (changed) wakeUnsupported(state, model_);
  changed = stepBlocks(state, model_, period_ns) || changed;
  stepTask(state.task, state, model_, driveControls(sample), changed);
}

void World::stepVehicles(WorldState& state, const MotionSample& sample, std::int64_t period_ns) const {
  const DriveControls controls = driveControls(sample);
  Surroundings around{model_.solids, model_.doors, {state.doors.data(), state.doors.size()}};
  if (model_.robot) around.other = &state.robot, around.other_model = &*model_.robot;
  const bool robot_drives = state.mode == Mode::Robot;
  drive(state.master, robot_drives ? DriveControls{} : controls, period_ns, model_.master, around);
  if (!model_.robot) return;
  around.other = &state.master;
  around.other_model = &model_.master;
  drive(state.robot, robot_drives ? controls : DriveControls{}, period_ns, *model_.robot, around);
}

void World::stepDoors(WorldState& state, std::int64_t period_ns) const {
  for (std::size_t i = 0; i < state.doors.size(); ++i) {
    const DoorModel& door = model_.doors[i];
    const bool opens = somebodyBefore(door, state.master.base, model_.master) ||
                       (model_.robot && somebodyBefore(door, state.robot.base, *model_.robot));
    const std::int64_t change =
        opens ? kDoorOpen * period_ns / kOpensWithinNs : -(kDoorOpen * period_ns / kClosesWithinNs);
    state.doors[i] =
        static_cast<std::int32_t>(std::clamp<std::int64_t>(state.doors[i] + change, 0, kDoorOpen));
  }
}

}  // namespace coherency
