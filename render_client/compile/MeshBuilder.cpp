#include "render_client/compile/MeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace coherency {
namespace {

using Face = std::vector<std::uint32_t>;

void checkIndices(const std::vector<Face>& faces, std::size_t vertex_count, const std::string& where) {
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const std::uint32_t v : faces[f])
      if (v >= vertex_count)
        throw std::invalid_argument(where + "face " + std::to_string(f) + " names vertex " +
                                    std::to_string(v) + " of a shape that has " +
                                    std::to_string(vertex_count));
}

void check(const FaceSet& faces) {
  checkIndices(faces.faces, faces.vertices.size(), "");
  double last = 0.0;
  for (std::size_t i = 0; i < faces.coarser.size(); ++i) {
    const std::string level = "coarser level " + std::to_string(i);
    checkIndices(faces.coarser[i].faces, faces.vertices.size(), level + ": ");
    const double error = faces.coarser[i].error;
    if (!(error > last) || !std::isfinite(error))
      throw std::invalid_argument(level + " has an error of " + std::to_string(error) +
                                  " m; it must be finite and above the last finer one's");
    last = error;
  }
}

Coord3 middle(const std::vector<Coord3>& vertices) {
  if (vertices.empty()) return {};
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Coord3 low{kFar, kFar, kFar};
  Coord3 high{-kFar, -kFar, -kFar};
  for (const Coord3& v : vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return 0.5 * (low + high);
}

/// Unit normal by the summed cross products of the fan; zero for a face without area.
Coord3 faceNormal(const FaceSet& faces, const Face& face) {
  Coord3 sum;
  for (std::size_t i = 2; i < face.size(); ++i) {
    const Coord3& a = faces.vertices[face[0]];
    sum += cross(faces.vertices[face[i - 1]] - a, faces.vertices[face[i]] - a);
  }
  const double length = norm(sum);
  return length > 0.0 && std::isfinite(length) ? sum / length : Coord3{};
}

double cornerAngle(const FaceSet& faces, const Face& face, std::size_t corner) {
  const std::size_t n = face.size();
  const Coord3& at = faces.vertices[face[corner]];
  const Coord3 next = faces.vertices[face[(corner + 1) % n]] - at;
  const Coord3 previous = faces.vertices[face[(corner + n - 1) % n]] - at;
  return std::atan2(norm(cross(next, previous)), dot(next, previous));
}

class Builder {
 public:
  explicit Builder(const FaceSet& faces) : faces_(faces), corners_at_(faces.vertices.size()) {
    check(faces);
    mesh_.origin = middle(faces.vertices);
    for (const Face& face : faces.faces) normals_.push_back(faceNormal(faces, face));
    if (faces.smooth) collectCorners();
    emitted_at_.resize(faces.vertices.size());
  }

  Mesh build() {
    for (std::size_t f = 0; f < faces_.faces.size(); ++f)
      if (normals_[f] != Coord3{}) addFace(f);
    for (const DetailLevel& level : faces_.coarser) addLevel(level);
    return std::move(mesh_);
  }

 private:
  struct Corner {
    std::size_t face;
    double angle;
  };

  void collectCorners() {
    for (std::size_t f = 0; f < faces_.faces.size(); ++f)
      for (std::size_t c = 0; c < faces_.faces[f].size(); ++c)
        corners_at_[faces_.faces[f][c]].push_back({f, cornerAngle(faces_, faces_.faces[f], c)});
  }

  void addFace(std::size_t f) {
    const auto vertex = [&](std::uint32_t v) { return addVertex(v, normalAt(f, v)); };
    addFan(faces_.faces[f], vertex, mesh_.indices);
  }

  void addLevel(const DetailLevel& level) {
    MeshLevel made{{}, level.error};
    for (const Face& face : level.faces) {
      const Coord3 normal = faceNormal(faces_, face);
      const auto vertex = [&](std::uint32_t v) { return nearestVertex(v, normal); };
      if (normal != Coord3{}) addFan(face, vertex, made.indices);
    }
    mesh_.coarser.push_back(std::move(made));
  }

  static void addFan(const Face& face, const auto& vertex, std::vector<std::uint32_t>& indices) {
    const std::uint32_t first = vertex(face[0]);
    std::uint32_t last = vertex(face[1]);
    for (std::size_t i = 2; i < face.size(); ++i) {
      const std::uint32_t next = vertex(face[i]);
      indices.insert(indices.end(), {first, last, next});
      last = next;
    }
  }

  Coord3 normalAt(std::size_t f, std::uint32_t vertex) const {
    if (!faces_.smooth) return normals_[f];
    const double crease = std::cos(faces_.crease_angle) - 1e-9;
    Coord3 sum;
    for (const Corner& corner : corners_at_[vertex])
      if (dot(normals_[corner.face], normals_[f]) >= crease) sum += corner.angle * normals_[corner.face];
    const double length = norm(sum);
    return length > 0.0 ? sum / length : normals_[f];
  }

  std::uint32_t nearestVertex(std::uint32_t vertex, const Coord3& normal) {
    const auto along = [&](std::uint32_t made) {
      const float(&n)[3] = mesh_.vertices[made].normal;
      return dot(Coord3{n[0], n[1], n[2]}, normal);
    };
    const std::vector<std::uint32_t>& all = emitted_at_[vertex];
    if (all.empty()) return addVertex(vertex, normal);
    return *std::max_element(all.begin(), all.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
  }

  /// The vertex with this normal, shared with a neighbour that has the same.
  std::uint32_t addVertex(std::uint32_t vertex, const Coord3& n) {
    const Coord3 p = faces_.vertices[vertex] - mesh_.origin;
    const MeshVertex made{{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                          {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}};
    for (const std::uint32_t other : emitted_at_[vertex])
      if (std::equal(made.normal, made.normal + 3, mesh_.vertices[other].normal,
                     [](float a, float b) { return std::abs(a - b) < 1e-6F; }))
        return other;
    const auto index = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(made);
    emitted_at_[vertex].push_back(index);
    return index;
  }

  const FaceSet& faces_;
  std::vector<Coord3> normals_;
  std::vector<std::vector<Corner>> corners_at_;
  std::vector<std::vector<std::uint32_t>> emitted_at_;
  Mesh mesh_;
};

}  // namespace

Mesh buildMesh(const FaceSet& faces) {
  return Builder(faces).build();
}

}  // namespace coherency
