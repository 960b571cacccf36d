#pragma once

#include <functional>
#include <vector>

#include "common/world/BasePose.h"
#include "motion_server/device/simulated/ReachPlanner.h"

namespace coherency {

/// Where to sit so that things are in reach: who finds one too far to the side moves the seat along. Bodies
/// of `scale` times the planner's size.
class Seating {
 public:
  /// `planner` outlives this; `grasp_point` as in OperatorTask.
  Seating(const ReachPlanner& planner, const Coord3& grasp_point)
      : planner_(planner), grasp_point_(grasp_point) {}

  /// Whether the hand can grasp what is at `place` (world).
  bool gets(const Coord3& place, const BasePose& base, double scale) const;
  /// And come to it from above.
  bool reaches(const Coord3& thing, const BasePose& base, double scale) const;
  /// Whether it reaches all of them, and the top of a tower upon one.
  bool canBuild(const std::vector<Coord3>& blocks, const BasePose& base, double scale) const;
  /// The place beside `workplace` from which none of the things needs more of a stretch than it must, of
  /// those that are clear; the workplace itself where all are near.
  BasePose place(const BasePose& workplace, const std::vector<Coord3>& things, double scale,
                 const std::function<bool(const BasePose&)>& clear) const;

 private:
  double stretch(const Coord3& place, const BasePose& base, double scale) const;
  double stretchOver(const Coord3& thing, const BasePose& base, double scale) const;

  const ReachPlanner& planner_;
  Coord3 grasp_point_;
};

}  // namespace coherency
