#include "render_client/compile/Lightmap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>

#include "render_client/compile/LightCanvas.h"

namespace coherency {
namespace {

constexpr int kWidest = 4096;         ///< texels, of the texture
constexpr int kHighest = 8192;        ///< texels
constexpr double kCoarsest = 0.25;    ///< m: light varies over half a metre near lamps
constexpr double kOfShortest = 0.75;  ///< of a surface's shortest edge: grid and triangles do not coincide

std::uint16_t share(float of_one) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(of_one, 0.0F, 1.0F) * 65535.0F));
}

}  // namespace

PackedLight packed(const SurfaceLight& surface) {
  const glm::vec3 light = surface.light / PackedLight::kBrightest;
  return {{share(light.r), share(light.g), share(light.b), share(surface.shade)}};
}

Lightmap::Lightmap(const FixedMesh& mesh, const std::vector<std::uint32_t>& uncut,
                   const std::vector<SurfaceLight>& light, double finest)
    : charts_(findCharts(mesh, uncut)), patches_(charts_.charts.size()) {
  if (patches_.empty()) return;
  while (!pack(finest)) finest *= 1.25;
  texels_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (std::size_t chart = 0; chart < patches_.size(); ++chart) paint(chart, mesh, light);
}

/// On shelves, highest first. False where there is no room.
bool Lightmap::pack(double finest) {
  double area = 0.0;
  int widest = 0;
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const Chart& chart = charts_.charts[i];
    const double texel = std::max(finest, std::min(kOfShortest * chart.shortest, kCoarsest));
    patches_[i].size = glm::ivec2(glm::max(glm::ceil(chart.size / texel), glm::dvec2(1.0))) + 1;
    area += (patches_[i].size.x + 2.0) * (patches_[i].size.y + 2.0);
    widest = std::max(widest, patches_[i].size.x + 2);
  }
  width_ = 64;
  while (width_ < kWidest && (width_ < widest || static_cast<double>(width_) * width_ < area)) width_ *= 2;
  if (widest > width_) return false;
  std::vector<std::size_t> order(patches_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return patches_[a].size.y > patches_[b].size.y; });
  glm::ivec2 free(0);  // the shelf's first texel that is
  height_ = 0;
  for (const std::size_t i : order) {
    const glm::ivec2 size = patches_[i].size + 2;
    if (free.x + size.x > width_) free = {0, height_};
    patches_[i].at = free + 1;
    free.x += size.x;
    height_ = std::max(height_, free.y + size.y);
  }
  return height_ <= kHighest;
}

glm::dvec2 Lightmap::inPatch(std::size_t chart, const FixedVertex& vertex) const {
  const Chart& from = charts_.charts[chart];
  return from.place(vertex) / glm::max(from.size, glm::dvec2(1e-9)) * glm::dvec2(patches_[chart].size - 1);
}

glm::vec2 Lightmap::place(const FixedMesh& mesh, std::uint32_t vertex) const {
  const std::uint32_t chart = charts_.of_vertex[vertex];
  const glm::dvec2 texel = glm::dvec2(patches_[chart].at) + 0.5 + inPatch(chart, mesh.vertices[vertex]);
  return glm::vec2(texel / glm::dvec2(width_, height_));
}

void Lightmap::paint(std::size_t chart, const FixedMesh& mesh, const std::vector<SurfaceLight>& light) {
  Patch& patch = patches_[chart];
  const std::vector<std::uint32_t>& cut = charts_.charts[chart].cut;
  LightCanvas canvas(patch.size);
  for (std::size_t i = 0; i + 2 < cut.size(); i += 3) {
    glm::dvec2 corner[3];
    SurfaceLight of_corner[3];
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = inPatch(chart, mesh.vertices[cut[i + c]]);
      of_corner[c] = light[cut[i + c]];
      patch.shaded = patch.shaded || of_corner[c].shade > kWorthShading;
    }
    canvas.paint(corner, of_corner);
  }
  canvas.spread(2);
  for (int y = -1; y <= patch.size.y; ++y)
    for (int x = -1; x <= patch.size.x; ++x) {
      const glm::ivec2 to = patch.at + glm::ivec2(x, y);
      const std::size_t number =
          static_cast<std::size_t>(to.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(to.x);
      texels_[number] = packed(canvas.at(glm::clamp(glm::ivec2(x, y), glm::ivec2(0), patch.size - 1)));
    }
}

}  // namespace coherency
