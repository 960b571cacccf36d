#include "common/scene/Polygon.h"

#include <numeric>

#include "common/scene/FaceCheck.h"

namespace coherency {

Polygon::Polygon(std::vector<Coord3> vertices, std::string name) : VRObject(std::move(name)) {
  setShape(std::move(vertices));
}

void Polygon::setShape(std::vector<Coord3> vertices) {
  checkFace(vertices, "Polygon '" + name() + "'");
  std::vector<std::uint32_t> face(vertices.size());
  std::iota(face.begin(), face.end(), 0u);
  if (vertices == faces_.vertices) return;
  faces_.vertices = std::move(vertices);
  faces_.faces = {std::move(face)};
  tell(ObjectChange::Reshaped);
}

void Polygon::setMaterial(const Material& material) {
  if (material == faces_.material) return;
  faces_.material = material;
  tell(ObjectChange::Repainted);
}

}  // namespace coherency
