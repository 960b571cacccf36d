#include "motion_server/device/simulated/Seating.h"

#include <algorithm>

namespace coherency {

namespace {

constexpr double kFarthest = 0.98;  // of the straight arm
constexpr double kEasy = 0.90;      // nobody moves the seat for less
constexpr double kAbove = 0.05;     // m, the hand comes from above
constexpr double kTower = 0.11;     // m, a tower is built upon one of them
constexpr double kStep = 0.02;      // m
constexpr int kSteps = 25;          // to each side

BasePose aside(const BasePose& base, double right_m) {
  const Coord3 way = transform(base).vector({right_m, 0.0, 0.0});
  BasePose moved = base;
  moved.x_nm = movedBy(base.x_nm, way.x);
  moved.z_nm = movedBy(base.z_nm, way.z);
  return moved;
}

}  // namespace

double Seating::stretch(const Coord3& place, const BasePose& base, double scale) const {
  const Coord3 there = transform(base).rigidInverse().point(place) / scale;
  return planner_.stretch(planner_.palmFor(there, grasp_point_));
}

double Seating::stretchOver(const Coord3& thing, const BasePose& base, double scale) const {
  return std::max(stretch(thing, base, scale), stretch(thing + Coord3{0.0, kAbove, 0.0}, base, scale));
}

bool Seating::gets(const Coord3& place, const BasePose& base, double scale) const {
  return stretch(place, base, scale) <= kFarthest;
}

bool Seating::reaches(const Coord3& thing, const BasePose& base, double scale) const {
  return stretchOver(thing, base, scale) <= kFarthest;
}

bool Seating::canBuild(const std::vector<Coord3>& blocks, const BasePose& base, double scale) const {
  return std::all_of(blocks.begin(), blocks.end(),
                     [&](const Coord3& block) { return reaches(block, base, scale); }) &&
         std::any_of(blocks.begin(), blocks.end(), [&](const Coord3& block) {
           return gets(block + Coord3{0.0, kTower, 0.0}, base, scale);
         });
}

BasePose Seating::place(const BasePose& workplace, const std::vector<Coord3>& things, double scale,
                        const std::function<bool(const BasePose&)>& clear) const {
  const auto worst = [&](const BasePose& base) {
    double most = kEasy;
    double easiest = things.empty() ? 0.0 : 9.0;
    for (const Coord3& thing : things) {
      most = std::max(most, stretchOver(thing, base, scale));
      easiest = std::min(easiest, stretch(thing + Coord3{0.0, kTower, 0.0}, base, scale));
    }
    return std::max(most, easiest);
  };
  BasePose best = workplace;
  double least = worst(best);
  for (int step = 1; step <= kSteps && least > kEasy; ++step)
    for (const double side : {-1.0, 1.0}) {
      const BasePose base = aside(workplace, side * step * kStep);
      if (const double most = worst(base); most < least && clear(base)) least = most, best = base;
    }
  return best;
}

}  // namespace coherency
