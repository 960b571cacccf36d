#include "common/world/Blocks.h"

#include <algorithm>
#include <cmath>

#include "common/math/FixedPoint.h"
#include "common/math/Rotation.h"
#include "common/world/Neighbourhood.h"

namespace coherency {

namespace {

constexpr double kGravity = 9.80665;  // m/s^2
constexpr double kRise = 0.6;         // m/s, out of what a cube was let go in
constexpr double kPush = 0.4;         // m/s, beside it
constexpr double kRighting = 6.0;     // rad/s, onto the nearest face
constexpr double kTipping = 4.0;      // rad/s, over an edge
constexpr double kOutside = 5e-4;     // m, centre off its support that does not tip yet
constexpr double kTouching = 2e-9;    // m, what rounding to nanometres leaves
constexpr double kFalling = 1.0;      // m/s, faster is no search for rest

void moveBy(Movable& m, const Coord3& metres) {
  m.x_nm = movedBy(m.x_nm, metres.x);
  m.y_nm = movedBy(m.y_nm, metres.y);
  m.z_nm = movedBy(m.z_nm, metres.z);
}

void turnBy(Movable& m, const TransformMatrix& turn) {
  setAttitude(m, quaternion(turn * rotation(attitude(m))));
}

/// Over the nearest edge of what carries it, which the centre has left.
void tip(Movable& m, const Support& support, PlanPoint edge, double period_s) {
  const PlanPoint away = edge * (-1.0 / length(edge));
  const Coord3 axis{away.z, 0.0, -away.x};  // up x away
  const TransformMatrix turn = TransformMatrix::rotation(axis, kTipping * period_s);
  const Coord3 pivot{edge.x, support.top, edge.z};
  moveBy(m, pivot - turn.vector(pivot));
  turnBy(m, turn);
  m.fall_um = 0;
}

void fall(Movable& m, double down_to, double period_s) {
  m.fall_um = static_cast<std::int32_t>(std::min(m.fall_um + std::round(kGravity * period_s / kMicrometre),
                                                 static_cast<double>(kFastestFallUm)));
  const double by = m.fall_um * kMicrometre * period_s;
  if (by >= down_to) m.fall_um = 0;
  moveBy(m, {0.0, -std::min(by, down_to), 0.0});
}

/// Turns towards lying flat on the face that is nearest to it.
void right(Movable& m, const Cube& cube, double period_s) {
  const Coord3 up = cube.up();
  const Coord3 axis{-up.z, 0.0, up.x};  // up x (0, 1, 0), its length the sine of the lean
  const double step = kRighting * period_s;
  const double sine = norm(axis);
  const bool nearly = up.y > 0.0 && sine <= step;  // the sine is no larger than the angle
  turnBy(m, nearly ? rotationBetween(up, {0.0, 1.0, 0.0}) : TransformMatrix::rotation(axis, step));
}

/// Sideways out of what it stands in. True where it was in nothing.
bool makeRoom(Movable& m, const Neighbourhood::Sideways& sideways, double period_s) {
  const double way = length(sideways.way);
  if (way == 0.0) return true;
  const double share = std::min(1.0, kPush * period_s / way);
  moveBy(m, {sideways.way.x * share, 0.0, sideways.way.z * share});
  return false;
}

/// Its centre is over what carries it.
bool carries(const Support& support) {
  return support.area.empty() || length(nearestToOrigin(support.area)) <= kOutside;
}

/// Whether it goes on looking for a better place; what is wedged in a heap stays where it is in the end.
bool isPatient(Movable& m, double period_s) {
  if (m.fall_um * kMicrometre < kFalling)
    m.unrest_us =
        std::min(m.unrest_us + static_cast<std::uint32_t>(std::llround(period_s * 1e6)), kPatienceUs);
  return m.unrest_us < kPatienceUs;
}

void stepBlock(WorldState& state, const WorldModel& model, std::size_t which, double period_s) {
  Movable& m = state.movables[which];
  const Neighbourhood around(state, model, which);
  const Cube& cube = around.cube();
  const Support support = around.support();
  const double gap = -support.top - cube.lowest();  // over what carries it; negative: in it
  const bool touches = gap <= kTouching;
  bool clear = true;
  if (isPatient(m, period_s)) {
    const PlanPoint edge = support.area.empty() ? PlanPoint{} : nearestToOrigin(support.area);
    if (touches && length(edge) > kOutside) return tip(m, support, edge, period_s);
    const Neighbourhood::Sideways sideways = around.sideways();
    if (sideways.squeezed) {  // up is the way out
      moveBy(m, {0.0, kRise * period_s, 0.0});
      m.fall_um = 0;
      return;
    }
    clear = makeRoom(m, sideways, period_s);
  }
  if (!cube.isFlat()) right(m, cube, period_s);
  if (!touches)
    fall(m, gap, period_s);
  else if (gap < -kTouching)
    moveBy(m, {0.0, std::min(-gap, kRise * period_s), 0.0});
  else
    m.fall_um = 0;
  m.resting = touches && gap >= -kTouching && cube.isFlat() && clear;
  if (m.resting && carries(support) && length(around.sideways().way) == 0.0) m.unrest_us = 0;
}

/// Wakes what has lost its support. What is wedged stays without.
void wakeFalling(WorldState& state, const WorldModel& model) {
  for (std::size_t i = 0; i < state.movables.size(); ++i) {
    Movable& m = state.movables[i];
    if (m.holder != Holder::Nobody || !m.resting) continue;
    const Neighbourhood around(state, model, i);
    const Support support = around.support();
    const bool touches = -support.top - around.cube().lowest() <= kSameHeight;
    m.resting = touches && (carries(support) || m.unrest_us == kPatienceUs);
  }
}

}  // namespace

bool stepBlocks(WorldState& state, const WorldModel& model, std::int64_t period_ns) {
  const double period_s = static_cast<double>(period_ns) * 1e-9;
  bool moved = false;
  for (std::size_t i = 0; i < state.movables.size(); ++i) {
    if (state.movables[i].holder != Holder::Nobody || state.movables[i].resting) continue;
    stepBlock(state, model, i, period_s);
    moved = true;
  }
  if (moved) wakeFalling(state, model);
  return moved;
}

void wakeUnsupported(WorldState& state, const WorldModel& model) {
  for (Movable& m : state.movables) {
    if (m.holder != Holder::Nobody || m.unrest_us < kPatienceUs) continue;
    m.unrest_us = 0;  // what wedged it may be gone: it tries again
    m.resting = false;
  }
  wakeFalling(state, model);
}

bool towerStands(const WorldState& state, const WorldModel& model) {
  const auto standsOn = [&](std::size_t upper, std::size_t lower) {
    const Movable& a = state.movables[upper];
    const Movable& b = state.movables[lower];
    if (upper == lower || !a.resting || !b.resting) return false;
    const Cube cube(a, model.movables[upper].edge);
    const Cube below(b, model.movables[lower].edge);
    const PlanPoint apart = between(below.place(), cube.place());
    return std::abs(cube.above(below.place()) - cube.half() - below.half()) < kSameHeight &&
           std::max(std::abs(apart.x), std::abs(apart.z)) < below.half();
  };
  const std::size_t count = state.movables.size();
  for (std::size_t middle = 0; middle < count; ++middle)
    for (std::size_t top = 0; top < count; ++top)
      for (std::size_t bottom = 0; bottom < count; ++bottom)
        if (standsOn(top, middle) && standsOn(middle, bottom)) return true;
  return false;
}

}  // namespace coherency
