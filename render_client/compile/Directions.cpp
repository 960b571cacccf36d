#include "render_client/compile/Directions.h"

#include <algorithm>
#include <cmath>

#include "common/math/FixedPoint.h"
#include "common/math/Trigonometry.h"

namespace coherency {
namespace {

glm::vec2 onDisc(double share_of_area, double turns) {
  const double radius = std::sqrt(share_of_area);
  const SineCosine angle = sineCosine(kTurn * turns);
  return {radius * angle.cosine, radius * angle.sine};
}

}  // namespace

std::vector<glm::vec2> discPoints(std::size_t count) {
  constexpr double kPlastic = 1.32471795724474602596;
  std::vector<glm::vec2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / kPlastic;
    const double v = static_cast<double>(i) / (kPlastic * kPlastic);
    points.push_back(onDisc(u - std::floor(u), v - std::floor(v)));
  }
  return points;
}

std::vector<glm::vec3> cosineDirections(std::size_t count) {
  std::vector<glm::vec3> directions;
  for (const glm::vec2& p : discPoints(count))
    directions.emplace_back(p, std::sqrt(std::max(0.0F, 1.0F - p.x * p.x - p.y * p.y)));
  return directions;
}

glm::mat3 frameAbout(const glm::vec3& n) {
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1.0F / (sign + n.z);
  const float b = n.x * n.y * a;
  return {{1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace coherency
