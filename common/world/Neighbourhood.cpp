#include "common/world/Neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kOverlap = 2e-4;   // m, sideways, that is let be
constexpr double kSqueezed = 0.25;  // of the ways it is pushed, that are left when they are added up

bool within(PlanPoint apart, double reach) {
  return std::abs(apart.x) < reach && std::abs(apart.z) < reach;
}

}  // namespace

Neighbourhood::Neighbourhood(const WorldState& state, const WorldModel& model, std::size_t which)
    : model_(model), cube_(state.movables[which], model.movables[which].edge) {
  for (std::size_t i = 0; i < state.movables.size(); ++i) {
    const Movable& m = state.movables[i];
    if (i == which || m.holder != Holder::Nobody) continue;
    const Cube other(m, model.movables[i].edge);
    if (within(between(cube_.place(), other.place()), 2.0 * (cube_.half() + other.half())))
      others_.push_back({other, m.resting || i < which});
  }
}

bool Neighbourhood::isNear(const SolidBox& box) const {
  return within(between(cube_.place(), box.centre), 2.0 * cube_.half() + box.half_x + box.half_z);
}

Support Neighbourhood::support() const {
  const PlanRectangle square = cube_.square(cube_.place());
  Support best{-metresFromNanometres(cube_.place().y_nm), {}, true};
  const auto offer = [&](double top, const PlanRectangle& carrier) {
    if (top > 0.0 || top < best.top - kSameHeight) return;
    std::vector<PlanPoint> area = common(square, carrier);
    if (area.size() < 3) return;
    if (top > best.top + kSameHeight) best = {top, {}, false};
    if (best.floor) return;
    best.top = std::max(best.top, top);
    best.area.insert(best.area.end(), area.begin(), area.end());
  };
  for (const SolidBox& box : model_.solids)
    if (isNear(box)) offer(box.height - cube_.above(box.centre), rectangle(box, cube_.place()));
  for (const Other& other : others_)
    if (other.cube.isFlat())
      offer(other.cube.half() - cube_.above(other.cube.place()), other.cube.square(cube_.place()));
  best.area = hull(std::move(best.area));
  return best;
}

Neighbourhood::Sideways Neighbourhood::sideways() const {
  const PlanRectangle square = cube_.square(cube_.place());
  Sideways sum;
  double total = 0.0;
  const auto add = [&](const PlanRectangle& other) {
    const PlanContact contact = rectangleInRectangle(square, other);
    if (contact.depth <= kOverlap) return;
    sum.way = sum.way + contact.away * contact.depth;
    total += contact.depth;
  };
  for (const SolidBox& box : model_.solids) {
    const double bottom = -cube_.above(box.centre);
    if (isNear(box) && bottom < cube_.lowest() && bottom + box.height > kSameHeight - cube_.lowest())
      add(rectangle(box, cube_.place()));
  }
  for (const Other& other : others_)
    if (other.goes_first &&
        std::abs(cube_.above(other.cube.place())) < cube_.lowest() + other.cube.lowest() - kSameHeight)
      add(other.cube.square(cube_.place()));
  sum.squeezed = total > 0.0 && length(sum.way) < kSqueezed * total;
  return sum;
}

}  // namespace coherency
