#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "common/world/WorldState.h"
#include "motion_server/device/simulated/Variation.h"

namespace coherency {

/// What lies lower is not bent down for, m.
inline constexpr double kLowestWork = 0.4;

/// One block to be taken somewhere.
struct Transfer {
  std::size_t block = 0;  ///< number of the movable
  Coord3 to;              ///< its centre's place when it is done, m, world
};

/// What to do with the blocks, decided anew from what is seen: the next block goes onto the tower; once a
/// tower of all stands, they are put back where they were, and it begins again (paper, section V: pick up a
/// block, put it on another, put the third on top).
class Workplan {
 public:
  /// `edges`: of the movables, m.
  explicit Workplan(std::vector<double> edges) : edges_(std::move(edges)) {}

  /// Whether a block there (m, world) can be had.
  using Reaches = std::function<bool(const Coord3&)>;

  /// Nothing to do: fewer than three blocks are within reach and none is out of place. Of several places to
  /// build at the one nearest to `comfortable` is taken.
  std::optional<Transfer> next(const WorldState& world, const Reaches& reaches, const Coord3& comfortable,
                               Chance& chance);

  /// Takes note where the blocks are before anything is done to them.
  void remember(const WorldState& world);

 private:
  std::vector<std::size_t> tower(const WorldState& world, std::size_t bottom) const;
  std::optional<Transfer> build(const WorldState& world, const std::vector<std::size_t>& usable,
                                const Coord3& comfortable, Chance& chance) const;
  std::optional<Transfer> clear(const WorldState& world, const std::vector<std::size_t>& usable) const;

  std::vector<double> edges_;
  std::vector<Coord3> homes_;  ///< where the blocks were, world
  bool building_ = true;
};

}  // namespace coherency
