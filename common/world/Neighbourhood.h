#pragma once

#include <vector>

#include "common/world/Cube.h"
#include "common/world/WorldModel.h"

namespace coherency {

/// Tops that differ by less, metres, carry together.
inline constexpr double kSameHeight = 1e-3;

/// What a cube finds below its centre.
struct Support {
  double top = 0.0;             ///< height of the highest top there, relative to the cube's centre
  std::vector<PlanPoint> area;  ///< hull of where such tops and its own square meet; empty for the floor
  bool floor = true;            ///< it is the floor, which is everywhere
};

/// One movable that nobody holds, and what is near it: solids, and other movables that nobody holds. Plan
/// points are relative to the movable's centre.
class Neighbourhood {
 public:
  /// Of movable number `which`. `model` outlives this.
  Neighbourhood(const WorldState& state, const WorldModel& model, std::size_t which);

  const Cube& cube() const { return cube_; }

  /// Solids' tops, tops of cubes that lie flat, and the floor (y = 0) carry.
  Support support() const;

  /// How it must move sideways to stand in nothing; of two movables that move the later makes room.
  struct Sideways {
    PlanPoint way;          ///< m
    bool squeezed = false;  ///< it would have to go both ways
  };
  Sideways sideways() const;

 private:
  struct Other {
    Cube cube;
    bool goes_first;  ///< it stays where it is
  };
  bool isNear(const SolidBox& box) const;

  const WorldModel& model_;
  Cube cube_;
  std::vector<Other> others_;
};

}  // namespace coherency
