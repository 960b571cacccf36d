#include "common/world/Cube.h"

#include <cmath>

#include "common/math/FixedPoint.h"
#include "common/math/Rotation.h"

namespace coherency {

Cube::Cube(const Movable& movable, double edge)
    : half_(0.5 * edge),
      turn_(rotation(attitude(movable))),
      place_{movable.x_nm, movable.y_nm, movable.z_nm, 0} {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(turn_(1, axis)) > std::abs(turn_(1, upright_))) upright_ = axis;
}

double Cube::lowest() const {
  return half_ * (std::abs(turn_(1, 0)) + std::abs(turn_(1, 1)) + std::abs(turn_(1, 2)));
}

Coord3 Cube::up() const {
  const Coord3 axis{turn_(0, upright_), turn_(1, upright_), turn_(2, upright_)};
  return axis.y < 0.0 ? -axis : axis;
}

bool Cube::isFlat() const {
  constexpr double kLean = 1e-8;  // sine of a lean taken as none: attitudes are kept to 1e-9
  const Coord3 axis = up();
  return axis.x * axis.x + axis.z * axis.z < kLean * kLean;
}

PlanRectangle Cube::square(const BasePose& origin) const {
  const int side = (upright_ + 1) % 3;
  const PlanPoint along{turn_(0, side), turn_(2, side)};
  const PlanPoint x = along * (1.0 / length(along));
  return {between(origin, place_), x, {-x.z, x.x}, half_, half_};
}

double Cube::above(const BasePose& other) const {
  return metresFromNanometres(place_.y_nm - other.y_nm);
}

}  // namespace coherency
