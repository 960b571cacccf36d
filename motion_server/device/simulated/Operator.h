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
#include "motion_server/device/simulated/Variation.h"
#include "motion_server/device/simulated/Workplan.h"

namespace coherency {

/// What the simulated operator has to do; all in world coordinates.
struct OperatorTask {
  std::vector<double> edges;    ///< of the movables there are, m
  std::vector<Coord3> targets;  ///< where to put a hand when there is nothing to build with (Scene::targets)
  BasePose workplace;           ///< where the base should be to reach them
  BasePose robot_workplace;     ///< and the robot's
  double robot_scale = 1.0;
  Coord3 grasp_point;  ///< of what a hand grasps best, from the middle of the palm in the hand's axes, m
};

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
  void reach(const std::function<Coord3()>& palm_body, double width_m);
  void grip(double wished, double takes_s, double wait_s);
  Coord3 strayed() const;
  Coord3 palmOnto(const Coord3& block_world) const;
  Coord3 palmCarrying(std::size_t block, const Coord3& to_world) const;
  bool holds(std::size_t block) const;

  double steer(double time_s);
  void lookWhereDriving(double time_s);
  double lookAt(const Coord3& point_body, double time_s);
  const BasePose& workplace() const;
  bool atWorkplace() const;
  Embodied body() const { return {world_, task_.robot_scale}; }

  OperatorTask task_;
  Chance chance_;
  Gaze gaze_;
  Arm arm_;
  Driver driver_;
  Workplan workplan_;
  WorldState world_;
  TransformMatrix felt_;
  std::deque<Act> agenda_;
  double now_ = 0.0;
  double next_act_at_ = 0.0;
  double next_glance_at_ = 0.0;
  double give_up_at_ = 0.0;
  DriveGoal goal_;
  std::optional<Coord3> aimed_;  // where the last reach of this transfer was to bring the palm, body
  bool begun_ = false;
  bool gave_up_ = false;  // the workplace could not be reached: work from here
  bool looked_round_ = false;
  std::uint32_t towers_seen_ = 0;
  int pieces_left_ = 4;  // of work, until a change
};

}  // namespace coherency
