#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "render_client/compile/Charts.h"
#include "render_client/compile/LightBaker.h"

namespace coherency {

/// As it lies in a vertex or a texel: irradiance / kBrightest and SurfaceLight::shade, as shares of 65535.
struct PackedLight {
  static constexpr float kBrightest = 16.0F;
  std::uint16_t share[4];
};
PackedLight packed(const SurfaceLight& surface);
/// What is in less of a shadow than this is drawn without.
inline constexpr float kWorthShading = 0.02F;

/// The light of flat surfaces that had to be cut for it, as a texture: they are drawn as they were before,
/// which costs a fraction of drawing what they were cut into. Each is a rectangle of texels about as fine as
/// it was cut; its light is right at their middles, and one row of texels is around it, so that filtering
/// never meets another surface's.
class Lightmap {
 public:
  /// The mesh as cut, with the light of its vertices, and its triangles as they were before. Texels are no
  /// finer than `finest`, m, and coarser all over where more than 8192 x 4096 would be needed.
  Lightmap(const FixedMesh& mesh, const std::vector<std::uint32_t>& uncut,
           const std::vector<SurfaceLight>& light, double finest);

  int width() const { return width_; }  ///< texels; 0 where nothing had to be cut
  int height() const { return height_; }
  const std::vector<PackedLight>& texels() const { return texels_; }  ///< row by row
  std::size_t chartCount() const { return patches_.size(); }          ///< surfaces that have their light here

  /// Whether the triangles about a vertex have their light from here.
  bool has(std::uint32_t vertex) const {
    return !charts_.of_vertex.empty() && charts_.of_vertex[vertex] != Charts::kNone;
  }
  /// Of a vertex it has: where in the texture, 0..1 both ways.
  glm::vec2 place(const FixedMesh& mesh, std::uint32_t vertex) const;
  /// Of a vertex it has: whether what moves could keep light away from some of its surface.
  bool isShaded(std::uint32_t vertex) const { return patches_[charts_.of_vertex[vertex]].shaded; }

 private:
  struct Patch {
    glm::ivec2 size{0};  ///< texels, without those around it
    glm::ivec2 at{0};    ///< of the first of them, in the texture
    bool shaded = false;
  };

  bool pack(double finest);
  void paint(std::size_t chart, const FixedMesh& mesh, const std::vector<SurfaceLight>& light);
  glm::dvec2 inPatch(std::size_t chart, const FixedVertex& vertex) const;

  int width_ = 0;
  int height_ = 0;
  std::vector<PackedLight> texels_;
  Charts charts_;
  std::vector<Patch> patches_;  ///< by chart
};

}  // namespace coherency
