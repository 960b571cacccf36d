#include "common/scene/Polyhedron.h"

#include <cmath>
#include <stdexcept>

#include "common/scene/FaceCheck.h"

namespace coherency {
namespace {

std::vector<Coord3> cornersOf(const std::vector<std::uint32_t>& face, const std::vector<Coord3>& vertices,
                              const std::string& what) {
  std::vector<Coord3> corners;
  corners.reserve(face.size());
  for (const std::uint32_t index : face) {
    if (index >= vertices.size())
      throw std::invalid_argument(what + ": index " + std::to_string(index) + " is out of range; there are " +
                                  std::to_string(vertices.size()) + " vertices");
    corners.push_back(vertices[index]);
  }
  return corners;
}

}  // namespace

Polyhedron::Polyhedron(std::vector<Coord3> vertices, std::vector<std::vector<std::uint32_t>> faces,
                       std::string name)
    : VRObject(std::move(name)) {
  setShape(std::move(vertices), std::move(faces));
}

void Polyhedron::setShape(std::vector<Coord3> vertices, std::vector<std::vector<std::uint32_t>> faces,
                          bool smooth) {
  const std::string self = "Polyhedron '" + name() + "'";
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!isFinite(vertices[i]))
      throw std::invalid_argument(self + ": vertex " + std::to_string(i) + " is not finite");
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::string what = self + ": face " + std::to_string(i);
    checkFace(cornersOf(faces[i], vertices, what), what);
  }
  if (vertices == faces_.vertices && faces == faces_.faces && smooth == faces_.smooth) return;
  faces_.vertices = std::move(vertices);
  faces_.faces = std::move(faces);
  faces_.smooth = smooth;
  tell(ObjectChange::Reshaped);
}

void Polyhedron::setCreaseAngle(double angle_rad) {
  if (!(angle_rad >= 0.0) || !std::isfinite(angle_rad))
    throw std::invalid_argument("Polyhedron '" + name() + "': crease angle must be finite and not negative");
  if (angle_rad == faces_.crease_angle) return;
  faces_.crease_angle = angle_rad;
  tell(ObjectChange::Reshaped);
}

void Polyhedron::setMaterial(const Material& material) {
  if (material == faces_.material) return;
  faces_.material = material;
  tell(ObjectChange::Repainted);
}

}  // namespace coherency
