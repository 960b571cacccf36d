#include "motion_server/device/simulated/Operator.h"

#include <cmath>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kSteeringStep = 0.05;  // s
constexpr double kLongestDrive = 25.0;  // s; then something is in the way
constexpr double kOpenGrip = 0.04;
constexpr double kHoldingGrip = 0.72;
constexpr double kGraspWidth = 0.03;    // m, how exactly a grasp is aimed
constexpr double kTransitWidth = 0.06;  // and what lies on the way
constexpr double kFixation = 0.35;      // s, the shortest look

}  // namespace

Operator::Operator(const OperatorTask& task, const Rig& rig, std::uint64_t seed)
    : task_(task), chance_(seed), arm_(rig) {
  world_.base = task.start;
  next_act_at_ = chance_.between(0.3, 0.8);
}

void Operator::advance(double time_s, const WorldState& world) {
  driver_.update(world, std::fmax(0.0, time_s - now_));
  now_ = time_s;
  world_ = world;
  while (time_s >= next_act_at_) {
    if (agenda_.empty()) planNext();
    const Act act = std::move(agenda_.front());
    agenda_.pop_front();
    next_act_at_ = time_s + act(time_s);
  }
}

void Operator::planNext() {
  if (!looked_round_) {
    looked_round_ = true;
    planGlance();
    planGlance();
  } else if (!atWorkplace() && !gave_up_) {
    planDrive(driveGoal(task_.workplace));
  } else if (cycles_left_ == 0) {
    cycles_left_ = 3 + static_cast<int>(chance_.below(4));
    planExcursion();
  } else {
    --cycles_left_;
    if (!task_.targets.empty()) planPickAndPlace();
    if (task_.targets.empty() || chance_.happens(0.4)) planGlance();
  }
}

void Operator::planDrive(const DriveGoal& goal) {
  agenda_.push_back([this](double t) {
    arm_.closeTo(kRelaxedGrip, t, 0.5);
    return arm_.goToRest(t, chance_);
  });
  agenda_.push_back([this, goal](double t) {
    goal_ = goal;
    driver_.driveTo(goal);
    give_up_at_ = t + kLongestDrive;
    next_glance_at_ = t;
    return steer(t);
  });
}

double Operator::steer(double time_s) {
  gave_up_ = time_s > give_up_at_;
  if (driver_.arrived(world_) || gave_up_) {
    driver_.letGo();
    return chance_.between(0.5, 1.0);
  }
  if (time_s >= next_glance_at_) lookWhereDriving(time_s);
  agenda_.push_front([this](double t) { return steer(t); });
  return kSteeringStep;
}

void Operator::lookWhereDriving(double time_s) {
  const DriveGoal here = driveGoal(world_.base);
  const double distance = std::hypot(goal_.x - here.x, goal_.z - here.z);
  const Coord3 goal = toBody({goal_.x, metresFromNanometres(world_.base.y_nm) + 0.8, goal_.z});
  const Coord3 ahead{chance_.between(-0.4, 0.4), 0.7, -2.5};
  next_glance_at_ = time_s + lookAt(distance > 0.8 ? goal : ahead, time_s) + chance_.between(0.3, 0.9);
}

void Operator::planExcursion() {
  DriveGoal aside = driveGoal(task_.workplace);
  const double back = chance_.between(0.4, 0.8);
  aside.x += back * std::sin(aside.heading);
  aside.z += back * std::cos(aside.heading);
  aside.heading += chance_.between(-0.4, 0.4);
  planDrive(aside);
  planGlance();
  planDrive(driveGoal(task_.workplace));
}

void Operator::planPickAndPlace() {
  const std::size_t count = task_.targets.size();
  const std::size_t from = held_ < count ? held_ : 0;
  const std::size_t to = count > 1 ? (from + 1 + chance_.below(count - 1)) % count : from;
  held_ = chance_.happens(0.5) ? to : chance_.below(count);
  const Coord3 pick = task_.targets[from];
  const Coord3 place = task_.targets[to];
  // The gaze gets there first: the hand starts 150 to 300 ms later.
  const auto look = [this](const Coord3& target) {
    agenda_.push_back([this, target](double t) {
      lookAt(toBody(target), t);
      return chance_.between(0.15, 0.30);
    });
  };
  const auto reach = [this](const Coord3& target, double above, double width) {
    agenda_.push_back([=, this](double t) { return reachTo(target, above, width, t); });
  };
  const auto grip = [this](double wished, double takes, double wait) {
    agenda_.push_back([=, this](double t) {
      arm_.closeTo(wished, t, takes * chance_.between(0.9, 1.2));
      return wait;
    });
  };
  look(pick);
  grip(kOpenGrip, 0.45, 0.0);  // the hand opens on its way
  reach(pick, 0.0, kGraspWidth);
  grip(kHoldingGrip, 0.25, 0.35);
  reach(pick, kLift, kTransitWidth);
  look(place);
  reach(place, kLift, kTransitWidth);
  reach(place, 0.0, kGraspWidth);
  grip(kOpenGrip, 0.25, 0.35);
  reach(place, kLift, kTransitWidth);
  if (chance_.happens(0.5)) return;
  grip(kRelaxedGrip, 0.5, 0.0);
  agenda_.push_back([this](double t) { return arm_.goToRest(t, chance_) + chance_.between(0.2, 1.0); });
}

void Operator::planGlance() {
  agenda_.push_back([this](double t) {
    const Coord3 hand = arm_.planner().palm(arm_.at(t));
    const Coord3 lap{chance_.between(-0.1, 0.1), 0.55, -0.35};
    const Coord3 left{-2.0, chance_.between(0.8, 1.6), chance_.between(-2.0, -0.5)};
    const Coord3 right{2.0, chance_.between(0.8, 1.6), chance_.between(-2.0, -0.5)};
    const Coord3 ahead{chance_.between(-0.5, 0.5), 1.2, -2.0};
    const Coord3 places[] = {hand, lap, left, right, ahead};
    const double shift = lookAt(places[chance_.below(std::size(places))], t);
    return shift + kFixation + chance_.between(0.0, 0.8);
  });
}

double Operator::lookAt(const Coord3& point_body, double time_s) {
  return gaze_.shift(arm_.planner().body().facing(point_body, arm_.at(time_s).lean), time_s, chance_);
}

double Operator::reachTo(const Coord3& target_world, double above, double width_m, double time_s) {
  return arm_.reachTo(toBody(target_world + Coord3(0.0, above, 0.0)), width_m, time_s, chance_);
}

bool Operator::atWorkplace() const {
  const DriveGoal here = driveGoal(world_.base);
  const DriveGoal there = driveGoal(task_.workplace);
  return std::hypot(there.x - here.x, there.z - here.z) < 0.05 &&
         std::abs(std::remainder(there.heading - here.heading, kTurn)) < 0.08;
}

Coord3 Operator::toBody(const Coord3& point_world) const {
  return transform(world_.base).rigidInverse().point(point_world);
}

}  // namespace coherency
