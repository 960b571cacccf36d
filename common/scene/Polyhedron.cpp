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

void checkFaces(const std::vector<std::vector<std::uint32_t>>& faces, const std::vector<Coord3>& vertices,
                const std::string& self) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::string what = self + ": face " + std::to_string(i);
    checkFace(cornersOf(faces[i], vertices, what), what);
  }
}

void checkLevels(const std::vector<DetailLevel>& levels, const std::vector<Coord3>& vertices,
                 const std::string& self) {
  double last = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string what = self + ": coarser level " + std::to_string(i);
    if (!(levels[i].error > last) || !std::isfinite(levels[i].error))
      throw std::invalid_argument(what + ": error is " + std::to_string(levels[i].error) +
                                  " m; it must be finite and above the last finer one's, " +
                                  std::to_string(last) + " m");
    last = levels[i].error;
    checkFaces(levels[i].faces, vertices, what);
  }
}

}  // namespace

Polyhedron::Polyhedron(std::vector<Coord3> vertices, std::vector<std::vector<std::uint32_t>> faces,
                       std::string name)
    : VRObject(std::move(name)) {
  setShape(std::move(vertices), std::move(faces));
}

void Polyhedron::setShape(std::vector<Coord3> vertices, std::vector<std::vector<std::uint32_t>> faces,
                          bool smooth, std::vector<DetailLevel> coarser) {
  const std::string self = "Polyhedron '" + name() + "'";
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!isFinite(vertices[i]))
      throw std::invalid_argument(self + ": vertex " + std::to_string(i) + " is not finite");
  checkFaces(faces, vertices, self);
  checkLevels(coarser, vertices, self);
  if (vertices == faces_.vertices && faces == faces_.faces && smooth == faces_.smooth &&
      coarser == faces_.coarser)
    return;
  faces_.vertices = std::move(vertices);
  faces_.faces = std::move(faces);
  faces_.smooth = smooth;
  faces_.coarser = std::move(coarser);
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
