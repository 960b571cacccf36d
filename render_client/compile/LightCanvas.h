#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render_client/compile/LightBaker.h"

namespace coherency {

/// A grid of light that triangles are painted on: points of the grid are whole numbers from 0.
class LightCanvas {
 public:
  explicit LightCanvas(const glm::ivec2& size);

  /// Gives the points in a triangle what lies between the light of its corners.
  void paint(const glm::dvec2 (&corner)[3], const SurfaceLight (&light)[3]);
  /// Gives points beside what was painted the mean of their neighbours, some rings far.
  void spread(int rings);
  const SurfaceLight& at(const glm::ivec2& point) const { return light_[number(point)]; }

 private:
  std::size_t number(const glm::ivec2& point) const {
    return static_cast<std::size_t>(point.y) * static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(point.x);
  }
  void set(const glm::ivec2& point, const SurfaceLight& light);
  void spreadTo(const glm::ivec2& point, const std::vector<bool>& from);

  glm::ivec2 size_;
  std::vector<SurfaceLight> light_;
  std::vector<bool> painted_;
};

}  // namespace coherency
