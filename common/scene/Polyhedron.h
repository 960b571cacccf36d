#pragma once

#include "common/scene/FaceSet.h"
#include "common/scene/VRObject.h"

namespace coherency {

/// A general polyhedron (paper, section III.B). Vertices that are not finite, indices out of range, and faces
/// that are degenerate, not plane or not convex (the limits of Polygon) are refused with
/// std::invalid_argument naming them; so are coarser levels with such faces, or with errors that do not rise
/// from above zero.
class Polyhedron : public VRObject {
 public:
  explicit Polyhedron(std::string name = {}) : VRObject(std::move(name)) {}
  Polyhedron(std::vector<Coord3> vertices, std::vector<std::vector<std::uint32_t>> faces,
             std::string name = {});

  void setShape(std::vector<Coord3> vertices, std::vector<std::vector<std::uint32_t>> faces,
                bool smooth = false, std::vector<DetailLevel> coarser = {});
  /// See FaceSet::crease_angle; radians, 0 or more, else std::invalid_argument.
  void setCreaseAngle(double angle_rad);
  void setMaterial(const Material& material);
  void setColour(double r, double g, double b) {
    setMaterial({{r, g, b}, faces_.material.gloss, faces_.material.emission});
  }
  const FaceSet* faces() const override { return &faces_; }

 private:
  FaceSet faces_;
};

}  // namespace coherency
