#include "common/world/BasePose.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/FixedPoint.h"

namespace coherency {

std::int64_t movedBy(std::int64_t from_nm, double by_m) {
  const std::int64_t by_nm = std::llround(by_m / kNanometre);
  return std::clamp(from_nm + by_nm, -kWorldLimitNm, kWorldLimitNm);
}

TransformMatrix transform(const BasePose& base) {
  TransformMatrix t = TransformMatrix::rotationY(radiansFromUnits(base.heading_units));
  t.setOrigin(
      {metresFromNanometres(base.x_nm), metresFromNanometres(base.y_nm), metresFromNanometres(base.z_nm)});
  return t;
}

BasePose basePose(double x, double z, double heading) {
  const auto coordinate = [](double metres) {
    const std::int64_t nm = nanometresFromMetres(metres);
    if (nm < -kWorldLimitNm || nm > kWorldLimitNm)
      throw std::range_error("a coordinate lies beyond the end of the world, 1e9 m from its origin");
    return nm;
  };
  return {coordinate(x), 0, coordinate(z), unitsFromRadians(heading)};
}

}  // namespace coherency
