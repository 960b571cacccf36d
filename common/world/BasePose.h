#pragma once

#include <cstdint>

#include "common/math/TransformMatrix.h"

namespace coherency {

/// A place on a floor and which way one faces there: integer, so that it is the same bits in every replica.
struct BasePose {
  std::int64_t x_nm = 0;
  std::int64_t y_nm = 0;
  std::int64_t z_nm = 0;
  std::int32_t heading_units = 0;  ///< 2^-32 turns about +y; 0 faces -z; positive turns left
  bool operator==(const BasePose&) const = default;
};

/// The world ends here in each direction, a billion metres from the origin: what drives stops, what a scene
/// places beyond is refused.
inline constexpr double kWorldLimit = 1e9;  ///< m
inline constexpr std::int64_t kWorldLimitNm = static_cast<std::int64_t>(kWorldLimit) * 1'000'000'000;

/// A coordinate moved by some metres, to the nearest nanometre; it ends where the world does.
std::int64_t movedBy(std::int64_t from_nm, double by_m);

/// T_world_base.
TransformMatrix transform(const BasePose& base);
/// Nearest pose on the floor (y = 0); metres and radians. Throws std::range_error where a coordinate is not
/// finite or beyond the world's limit.
BasePose basePose(double x, double z, double heading);

}  // namespace coherency
