#include "motion_server/device/simulated/Workplan.h"

#include <algorithm>
#include <cmath>

namespace coherency {

namespace {

constexpr std::size_t kTower = 3;    // blocks of one
constexpr double kAtHome = 0.04;     // m, near enough to where it was
constexpr double kSameLevel = 2e-3;  // m

Coord3 place(const Movable& m) {
  return transform(m).origin();
}

double apart(const Coord3& a, const Coord3& b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

}  // namespace

void Workplan::remember(const WorldState& world) {
  homes_.clear();
  for (const Movable& m : world.movables) homes_.push_back(place(m));
}

/// Numbers of the blocks that stand upon each other, from `bottom` up.
std::vector<std::size_t> Workplan::tower(const WorldState& world, std::size_t bottom) const {
  std::vector<std::size_t> stack = {bottom};
  for (std::size_t found = 0; found < stack.size(); ++found) {
    const std::size_t below = stack[found];
    const Coord3 at = place(world.movables[below]);
    for (std::size_t i = 0; i < world.movables.size(); ++i) {
      const Movable& m = world.movables[i];
      const double step = (edges_[below] + edges_[i]) / 2;
      if (i == below || m.holder != Holder::Nobody || !m.resting) continue;
      if (std::abs(place(m).y - at.y - step) > kSameLevel || apart(place(m), at) > edges_[below] / 2)
        continue;
      stack.push_back(i);
      break;
    }
  }
  return stack;
}

std::optional<Transfer> Workplan::next(const WorldState& world, const Reaches& reaches,
                                       const Coord3& comfortable, Chance& chance) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < world.movables.size(); ++i) {
    const Movable& m = world.movables[i];
    const bool free = m.holder == Holder::Nobody && m.resting;
    if (free && place(m).y > kLowestWork && reaches(place(m))) usable.push_back(i);
  }
  if (usable.size() < kTower) return std::nullopt;
  if (building_) {
    if (const auto transfer = build(world, usable, comfortable, chance)) return transfer;
    building_ = false;  // it stands
  }
  if (const auto transfer = clear(world, usable)) return transfer;
  building_ = true;
  return build(world, usable, comfortable, chance);
}

/// Onto the highest stack there is; where all are alike, onto what is nearest to where the hand works best.
std::optional<Transfer> Workplan::build(const WorldState& world, const std::vector<std::size_t>& usable,
                                        const Coord3& comfortable, Chance& chance) const {
  std::vector<std::size_t> best;
  const auto away = [&](std::size_t block) { return apart(place(world.movables[block]), comfortable); };
  for (const std::size_t block : usable) {
    const auto stack = tower(world, block);
    if (stack.size() > best.size() || (stack.size() == best.size() && away(block) < away(best.front())))
      best = stack;
  }
  if (best.size() >= kTower) return std::nullopt;
  const std::size_t pick = chance.below(usable.size());
  for (std::size_t k = 0; k < usable.size(); ++k) {
    const std::size_t block = usable[(pick + k) % usable.size()];
    if (std::find(best.begin(), best.end(), block) != best.end() || tower(world, block).size() > 1) continue;
    const Coord3 top = place(world.movables[best.back()]);
    return Transfer{block, top + Coord3{0.0, (edges_[best.back()] + edges_[block]) / 2, 0.0}};
  }
  return std::nullopt;
}

/// Back where it was, from the top, unless somebody else is there now.
std::optional<Transfer> Workplan::clear(const WorldState& world,
                                        const std::vector<std::size_t>& usable) const {
  for (const std::size_t block : usable) {
    if (tower(world, block).size() > 1 || block >= homes_.size()) continue;  // something stands on it
    const Coord3 here = place(world.movables[block]);
    if (norm(here - homes_[block]) < kAtHome) continue;
    const bool taken = std::any_of(usable.begin(), usable.end(), [&](std::size_t other) {
      return other != block && apart(place(world.movables[other]), homes_[block]) < 1.5 * edges_[block];
    });
    if (!taken) return Transfer{block, homes_[block]};
  }
  return std::nullopt;
}

}  // namespace coherency
