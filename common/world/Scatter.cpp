#include "common/world/Scatter.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>

#include "common/math/FixedPoint.h"
#include "common/world/Driving.h"
#include "common/world/Neighbourhood.h"
#include "common/world/Places.h"

namespace coherency {

namespace {

constexpr int kTries = 1000;
constexpr double kApart = 1.8;  // edges: room for fingers

[[noreturn]] void refuse(const MovableModel& movable, const ScatterArea& area) {
  std::ostringstream text;
  text << "scatter: there is no room for '" << movable.name << "' at the height it has between x "
       << area.min_x << " and " << area.max_x << ", z " << area.min_z << " and " << area.max_z
       << " m: nothing carries it there, or something is in the way; give a free stretch of the surface it "
          "stands on";
  throw std::invalid_argument(text.str());
}

/// Number `which` stands on something, in nothing, and in nobody's way who begins there.
bool standsWell(const WorldState& state, const WorldModel& model, std::size_t which) {
  const Neighbourhood around(state, model, which);
  const Support support = around.support();
  if (std::abs(-support.top - around.cube().lowest()) > kSameHeight) return false;
  if (!support.area.empty() && length(nearestToOrigin(support.area)) > 0.0) return false;
  if (length(around.sideways().way) > 0.0) return false;
  const Movable& m = state.movables[which];
  const SolidBox box = boxOf(model.movables[which], {m.x_nm, m.y_nm, m.z_nm, 0});
  return !begins(model, box);
}

}  // namespace

void scatter(WorldState& state, const WorldModel& model, const ScatterArea& area, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto between01 = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  for (std::size_t i = 0; i < state.movables.size(); ++i) {
    const double apart = kApart * model.movables[i].edge;
    Movable& m = state.movables[i];
    for (int attempt = 0;; ++attempt) {
      if (attempt == kTries) refuse(model.movables[i], area);
      m.x_nm = nanometresFromMetres(area.min_x + (area.max_x - area.min_x) * between01());
      m.z_nm = nanometresFromMetres(area.min_z + (area.max_z - area.min_z) * between01());
      setAttitude(m, quaternion(TransformMatrix::rotationY((between01() - 0.5) * kTurn)));
      const auto clear = [&](const Movable& other) {
        return length(between({m.x_nm, 0, m.z_nm, 0}, {other.x_nm, 0, other.z_nm, 0})) > apart;
      };
      if (!std::all_of(state.movables.begin(), state.movables.begin() + static_cast<std::ptrdiff_t>(i),
                       clear))
        continue;
      WorldState strewn = state;  // those to come are still where they were, and in nobody's way
      strewn.movables.resize(i + 1);
      if (standsWell(strewn, model, i)) break;
    }
  }
}

}  // namespace coherency
