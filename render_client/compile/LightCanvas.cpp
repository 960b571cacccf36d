#include "render_client/compile/LightCanvas.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace coherency {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

template <class Visit>
void forEachPoint(const glm::ivec2& first, const glm::ivec2& last, const Visit& visit) {
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) visit(glm::ivec2(x, y));
}

/// What is buried is as it is beside it (Bake); nothing here is.
SurfaceLight between(const SurfaceLight (&light)[3], float b, float c) {
  const float a = 1.0F - b - c;
  return {a * light[0].light + b * light[1].light + c * light[2].light,
          a * light[0].shade + b * light[1].shade + c * light[2].shade, false};
}

}  // namespace

LightCanvas::LightCanvas(const glm::ivec2& size)
    : size_(size),
      light_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)),
      painted_(light_.size(), false) {}

void LightCanvas::set(const glm::ivec2& point, const SurfaceLight& light) {
  light_[number(point)] = light;
  painted_[number(point)] = true;
}

void LightCanvas::paint(const glm::dvec2 (&corner)[3], const SurfaceLight (&light)[3]) {
  constexpr double kOnEdge = 1e-3;  // of a triangle: rounding leaves no point between two of them out
  const double area = cross(corner[1] - corner[0], corner[2] - corner[0]);
  if (std::abs(area) < 1e-9) return;
  const glm::dvec2 low = glm::min(corner[0], glm::min(corner[1], corner[2])) - kOnEdge;
  const glm::dvec2 high = glm::max(corner[0], glm::max(corner[1], corner[2])) + kOnEdge;
  const glm::ivec2 first = glm::max(glm::ivec2(glm::ceil(low)), glm::ivec2(0));
  const glm::ivec2 last = glm::min(glm::ivec2(glm::floor(high)), size_ - 1);
  forEachPoint(first, last, [&](const glm::ivec2& point) {
    const glm::dvec2 from_corner = glm::dvec2(point) - corner[0];
    const double b = cross(from_corner, corner[2] - corner[0]) / area;
    const double c = cross(corner[1] - corner[0], from_corner) / area;
    if (std::min({b, c, 1.0 - b - c}) < -kOnEdge) return;
    set(point, between(light, static_cast<float>(b), static_cast<float>(c)));
  });
}

void LightCanvas::spread(int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<bool> before = painted_;
    forEachPoint(glm::ivec2(0), size_ - 1, [&](const glm::ivec2& point) {
      if (!before[number(point)]) spreadTo(point, before);
    });
  }
}

void LightCanvas::spreadTo(const glm::ivec2& point, const std::vector<bool>& from) {
  SurfaceLight sum;
  float count = 0.0F;
  forEachPoint(glm::max(point - 1, 0), glm::min(point + 1, size_ - 1), [&](const glm::ivec2& beside) {
    if (!from[number(beside)]) return;
    sum.light += at(beside).light;
    sum.shade += at(beside).shade;
    ++count;
  });
  if (count > 0.0F) set(point, {sum.light / count, sum.shade / count, false});
}

}  // namespace coherency
