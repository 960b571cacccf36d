#include "motion_server/device/simulated/Operator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kSteeringStep = 0.05;  // s
constexpr double kLongestDrive = 25.0;  // s; then something is in the way
constexpr double kOpenGrip = 0.04;
constexpr double kHoldingGrip = 0.72;
constexpr double kGraspWidth = 0.02;               // m, how exactly a grasp or a placing is aimed
constexpr double kTransitWidth = 0.06;             // and what lies on the way
constexpr double kLift = 0.10;                     // m, above what is taken or put down
constexpr double kLeastLift = 0.02;                // of which there always is some
constexpr double kLetGoAbove = 0.003;              // m, a block is let go over what it is put on
constexpr Coord3 kComfortable{0.19, 1.17, -1.02};  // arm's lengths, body: where the right hand works best
constexpr double kFixation = 0.35;                 // s, the shortest look

}  // namespace

Operator::Operator(const OperatorTask& task, const Rig& rig, std::uint64_t seed)
    : task_(task),
      chance_(seed),
      arm_(rig),
      seating_(arm_.planner(), task.grasp_point),
      workplan_(task.edges) {
  next_act_at_ = chance_.between(0.3, 0.8);
}

void Operator::advance(double time_s, const WorldState& world, const TransformMatrix& felt) {
  if (!begun_) workplan_.remember(world);
  if (begun_ && world.mode != world_.mode) {  // somebody else now: whatever was planned is of no use
    agenda_.clear();
    driver_.letGo();
    seat_.reset();
    gave_up_ = false;
  }
  begun_ = true;
  driver_.update(world, std::fmax(0.0, time_s - now_));
  now_ = time_s;
  world_ = world;
  felt_ = felt;
  while (time_s >= next_act_at_) {
    if (agenda_.empty()) planNext();
    const Act act = std::move(agenda_.front());
    agenda_.pop_front();
    next_act_at_ = time_s + act(time_s);
  }
}

void Operator::planNext() {
  if (!seat_) seat_ = chosenSeat();
  if (!looked_round_) {
    looked_round_ = true;
    planGlance();
    planGlance();
  } else if (!atWorkplace() && !gave_up_) {
    planDrive(driveGoal(*seat_));
  } else if (pieces_left_ == 0) {
    pieces_left_ = 4 + static_cast<int>(chance_.below(5));
    planExcursion();
  } else {
    --pieces_left_;
    planWork();
  }
}

void Operator::planWork() {
  if (world_.task.towers > towers_seen_) {
    towers_seen_ = world_.task.towers;
    return planPride();
  }
  const Embodied me = body();
  const auto reaches = [&](const Coord3& place) { return seating_.reaches(place, me.base, me.scale); };
  const auto transfer =
      workplan_.next(world_, reaches, me.toWorld(kComfortable * arm_.planner().armLength()), chance_);
  if (transfer) {
    planTransfer(*transfer);
  } else {
    if (!task_.targets.empty()) planTouch();
    planGlance();
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
  const Embodied me = body();
  const DriveGoal here = driveGoal(me.base);
  const double distance = std::hypot(goal_.x - here.x, goal_.z - here.z);
  const Coord3 goal = me.toBody({goal_.x, metresFromNanometres(me.base.y_nm) + 0.8, goal_.z});
  const Coord3 ahead{chance_.between(-0.4, 0.4), 0.7, -2.5};
  next_glance_at_ = time_s + lookAt(distance > 0.8 ? goal : ahead, time_s) + chance_.between(0.3, 0.9);
}

void Operator::planExcursion() {
  seat_ = chosenSeat();
  DriveGoal aside = driveGoal(*seat_);
  const double back = chance_.between(0.4, 0.8);
  aside.x += back * std::sin(aside.heading);
  aside.z += back * std::cos(aside.heading);
  aside.heading += chance_.between(-0.4, 0.4);
  planDrive(aside);
  planGlance();
  planDrive(driveGoal(*seat_));
}

void Operator::look(const Coord3& point_world) {
  // The gaze gets there first: the hand starts 150 to 300 ms later.
  agenda_.push_back([this, point_world](double t) {
    lookAt(body().toBody(point_world), t);
    return chance_.between(0.15, 0.30);
  });
}

void Operator::reach(const std::function<Aim()>& aim, double width_m) {
  agenda_.push_back([=, this](double t) {
    aimed_ = aim();
    return arm_.reachTo(arm_.planner().palmFor(aimed_->place, aimed_->in_hand), width_m, t, chance_);
  });
}

void Operator::grip(double wished, double takes_s, double wait_s) {
  agenda_.push_back([=, this](double t) {
    arm_.closeTo(wished, t, takes_s * chance_.between(0.9, 1.2));
    return wait_s;
  });
}

/// How far what was aimed in the last reach is from its place: seen, and made up for in the next one.
Coord3 Operator::strayed() const {
  return aimed_ ? felt_.point(aimed_->in_hand + palm()) - aimed_->place : Coord3{};
}

/// The hand is to close upon something there.
Operator::Aim Operator::onto(const Coord3& block_world) const {
  return {body().toBody(block_world) - strayed(), task_.grasp_point};
}

/// The block it holds is to be there; it is seen how it lies in the hand.
Operator::Aim Operator::carrying(std::size_t block, const Coord3& to_world) const {
  if (!holds(block)) return onto(to_world);  // it has been lost on the way
  const Embodied me = body();
  return {me.toBody(to_world) - strayed(), transform(world_.movables[block]).origin() / me.scale - palm()};
}

/// Middle of the palm in the hand's frame.
Coord3 Operator::palm() const {
  return {arm_.planner().body().rig().hand, 0.0, 0.0};
}

bool Operator::holds(std::size_t block) const {
  return world_.movables[block].holder == body().hand;
}

/// So much above a place, or as high as the hand gets there.
Coord3 Operator::above(const Coord3& place_world, double lift_m) const {
  const Embodied me = body();
  while (lift_m > kLeastLift && !seating_.gets(place_world + Coord3{0.0, lift_m, 0.0}, me.base, me.scale))
    lift_m -= kLeastLift;
  return place_world + Coord3{0.0, lift_m, 0.0};
}

void Operator::planTransfer(const Transfer& transfer) {
  const std::size_t block = transfer.block;
  const Coord3 from = transform(world_.movables[block]).origin();
  look(from);
  grip(kOpenGrip, 0.45, 0.0);  // the hand opens on its way
  aimed_.reset();
  reach([=, this] { return onto(above(from, 0.5 * kLift)); }, kTransitWidth);
  reach([=, this] { return onto(transform(world_.movables[block]).origin()); }, kGraspWidth);
  grip(kHoldingGrip, 0.25, 0.40);
  // Whoever sees that the hand has closed on nothing thinks again.
  agenda_.push_back([=, this](double) {
    if (!holds(block)) {
      grip(kOpenGrip, 0.3, 0.3);
      planRest();
      return 0.0;
    }
    reach([=, this] { return carrying(block, above(from, kLift)); }, kTransitWidth);
    look(transfer.to);
    reach([=, this] { return carrying(block, above(transfer.to, kLift)); }, kGraspWidth);
    reach([=, this] { return carrying(block, transfer.to + Coord3{0.0, 0.03, 0.0}); }, kGraspWidth);
    reach([=, this] { return carrying(block, transfer.to + Coord3{0.0, kLetGoAbove, 0.0}); }, kGraspWidth);
    grip(kOpenGrip, 0.3, 0.45);
    reach([=, this] { return onto(above(transfer.to, kLift)); }, kTransitWidth);
    if (chance_.happens(0.25)) planRest();
    return 0.0;
  });
}

void Operator::planTouch() {
  const Coord3 target = task_.targets[chance_.below(task_.targets.size())];
  look(target);
  grip(kOpenGrip, 0.45, 0.0);
  reach([=, this] { return Aim{body().toBody(target), {}}; }, kGraspWidth);
  grip(kHoldingGrip, 0.25, 0.35);
  grip(kOpenGrip, 0.25, 0.35);
  if (chance_.happens(0.5)) planRest();
}

/// Hands off, and a look at what has been built.
void Operator::planPride() {
  const auto highest = std::max_element(world_.movables.begin(), world_.movables.end(),
                                        [](const Movable& a, const Movable& b) { return a.y_nm < b.y_nm; });
  planRest();
  look(transform(*highest).origin());
  agenda_.push_back([this](double) { return chance_.between(2.5, 3.5); });
}

void Operator::planRest() {
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

BasePose Operator::chosenSeat() const {
  const BasePose& workplace = world_.mode == Mode::Robot ? task_.robot_workplace : task_.workplace;
  const auto clear = [this](const BasePose& base) { return !task_.clear || task_.clear(base, world_.mode); };
  return seating_.place(workplace, blocksNear(world_, workplace), body().scale, clear);
}

bool Operator::atWorkplace() const {
  const DriveGoal here = driveGoal(world_.driven().base);
  const DriveGoal there = driveGoal(*seat_);
  return std::hypot(there.x - here.x, there.z - here.z) < 0.05 &&
         std::abs(std::remainder(there.heading - here.heading, kTurn)) < 0.08;
}

}  // namespace coherency
