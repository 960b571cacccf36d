#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "common/world/WorldState.h"
#include "motion_server/device/simulated/Arm.h"
#include "motion_server/device/simulated/Driver.h"
#include "motion_server/device/simulated/Embodied.h"
#include "motion_server/device/simulated/Gaze.h"
#include "motion_server/device/simulated/OperatorTask.h"
#include "motion_server/device/simulated/Seating.h"
#include "motion_server/device/simulated/Variation.h"
#include "motion_server/device/simulated/Workplan.h"

namespace coherency {

/// Decides what to do next and sets gaze, arm and driver going: an agenda of acts, each of which starts
/// something and says how long to wait for the next. An empty agenda is filled with the next piece of
/// behaviour. All it knows of the world it sees: where blocks lie, what its hand holds, where it stands.
class Operator {
 public:
  Operator(const OperatorTask& task, const Rig& rig, std::uint64_t seed);

  /// Times must not go back. `felt` is the hand as the last reading had it, T_body_hand.
  void advance(double time_s, const WorldState& world, const TransformMatrix& felt);

  const Gaze& gaze() const { return gaze_; }
  const Arm& arm() const { return arm_; }
  const Driver& driver() const { return driver_; }

 private:
  using Act = std::function<double(double time_s)>;

  void planNext();
  void planWork();
  void planDrive(const DriveGoal& goal);
  void planExcursion();
  void planTransfer(const Transfer& transfer);
  void planTouch();
  void planGlance();
  void planPride();
  void planRest();

  void look(const Coord3& point_world);
  /// A reach brings what is `in_hand` (m, the hand's axes, from the middle of the palm) to `place` (body).
  struct Aim {
    Coord3 place;
    Coord3 in_hand;
  };
  void reach(const std::function<Aim()>& aim, double width_m);
  void grip(double wished, double takes_s, double wait_s);
  Coord3 strayed() const;
  Aim onto(const Coord3& block_world) const;
  Aim carrying(std::size_t block, const Coord3& to_world) const;
  Coord3 palm() const;
  Coord3 above(const Coord3& place_world, double lift_m) const;
  bool holds(std::size_t block) const;

  double steer(double time_s);
  void lookWhereDriving(double time_s);
  double lookAt(const Coord3& point_body, double time_s);
  BasePose chosenSeat() const;
  bool atWorkplace() const;
  Embodied body() const { return {world_, task_.robot_scale}; }

  OperatorTask task_;
  Chance chance_;
  Gaze gaze_;
  Arm arm_;
  Driver driver_;
  Seating seating_;
  Workplan workplan_;
  WorldState world_;
  TransformMatrix felt_;
  std::deque<Act> agenda_;
  double now_ = 0.0;
  double next_act_at_ = 0.0;
  double next_glance_at_ = 0.0;
  double give_up_at_ = 0.0;
  std::optional<BasePose> seat_;  // where to work
  DriveGoal goal_;
  std::optional<Aim> aimed_;  // by the last reach of this transfer
  bool begun_ = false;
  bool gave_up_ = false;  // the workplace could not be reached: work from here
  bool looked_round_ = false;
  std::uint32_t towers_seen_ = 0;
  int pieces_left_ = 4;  // of work, until a change
};

}  // namespace coherency
