#pragma once

#include "common/scene/FaceSet.h"
#include "common/scene/VRObject.h"

namespace coherency {

/// A single plane, convex polygon, seen from the side from which its vertices run counter-clockwise (paper,
/// section III.B). Fewer than three vertices, or vertices not in a plane (to 1e-6 of their extent), not
/// convex or not finite: std::invalid_argument.
class Polygon : public VRObject {
 public:
  explicit Polygon(std::string name = {}) : VRObject(std::move(name)) {}
  explicit Polygon(std::vector<Coord3> vertices, std::string name = {});

  void setShape(std::vector<Coord3> vertices);
  void setMaterial(const Material& material);
  void setColour(double r, double g, double b) {
    setMaterial({{r, g, b}, faces_.material.gloss, faces_.material.emission});
  }
  const FaceSet* faces() const override { return &faces_; }

 private:
  FaceSet faces_;
};

}  // namespace coherency
