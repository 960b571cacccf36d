#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "common/world/WorldState.h"
#include "motion_server/device/simulated/Arm.h"
#include "motion_server/device/simulated/Driver.h"
#include "motion_server/device/simulated/Gaze.h"
#include "motion_server/device/simulated/Variation.h"

namespace coherency {

/// What the simulated operator has to do; all in world coordinates.
struct OperatorTask {
  std::vector<Coord3> targets;  ///< where the middle of the palm goes to grasp (Scene::targets)
  BasePose workplace;           ///< where the base should be to reach them
  BasePose start;               ///< where the session begins
};

inline constexpr double kLift = 0.10;  ///< m, what is carried is lifted

/// Decides what to do next and sets gaze, arm and driver going: an agenda of acts, each of which starts
/// something and says how long to wait for the next. An empty agenda is filled with the next piece of
/// behaviour.
class Operator {
 public:
  Operator(const OperatorTask& task, const Rig& rig, std::uint64_t seed);

  /// Times must not go back.
  void advance(double time_s, const WorldState& world);

  const Gaze& gaze() const { return gaze_; }
  const Arm& arm() const { return arm_; }
  const Driver& driver() const { return driver_; }

 private:
  using Act = std::function<double(double time_s)>;

  void planNext();
  void planDrive(const DriveGoal& goal);
  void planExcursion();
  void planPickAndPlace();
  void planGlance();

  double steer(double time_s);
  void lookWhereDriving(double time_s);
  double lookAt(const Coord3& point_body, double time_s);
  double reachTo(const Coord3& target_world, double above, double width_m, double time_s);
  bool atWorkplace() const;
  Coord3 toBody(const Coord3& point_world) const;

  OperatorTask task_;
  Chance chance_;
  Gaze gaze_;
  Arm arm_;
  Driver driver_;
  WorldState world_;
  std::deque<Act> agenda_;
  double now_ = 0.0;
  double next_act_at_ = 0.0;
  double next_glance_at_ = 0.0;
  double give_up_at_ = 0.0;
  DriveGoal goal_;
  bool gave_up_ = false;  // the workplace could not be reached: work from here
  bool looked_round_ = false;
  int cycles_left_ = 4;
  std::size_t held_ = 0;  // index of the target that was last put down or is picked up next
};

}  // namespace coherency
