#include "render_client/compile/CompiledScene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "common/scene/Mobility.h"
#include "render_client/compile/Refine.h"

namespace coherency {
namespace {

constexpr std::uint32_t kWorld = 0;  ///< the node of what never moves

std::uint32_t count(const auto& list) {
  return static_cast<std::uint32_t>(list.size());
}

/// About a mesh's origin.
Coord3 halfExtent(const std::vector<MeshVertex>& vertices) {
  glm::dvec3 extent(0.0);
  for (const MeshVertex& v : vertices)
    extent = glm::max(extent, glm::abs(glm::dvec3(v.position[0], v.position[1], v.position[2])));
  return Coord3(extent);
}

double radius(const std::vector<MeshVertex>& vertices) {
  double square = 0.0;
  for (const MeshVertex& v : vertices) {
    const glm::dvec3 position(v.position[0], v.position[1], v.position[2]);
    square = std::max(square, glm::dot(position, position));
  }
  return std::sqrt(square);
}

/// Lamps' light varies over half a metre near them; what is larger than a room is scenery, which they do not
/// reach.
double lightingEdge(const VRObject& object, const Coord3& half_extent) {
  constexpr double kEdge = 0.6;
  constexpr double kRoom = 12.0;
  const double scale = std::max(object.globalTransform().maxScale(), 1e-9);
  const double size = 2.0 * std::max({half_extent.x, half_extent.y, half_extent.z});
  const bool lit = object.faces()->material.emission < 1.0 && size * scale < kRoom;
  return lit ? std::max(kEdge / scale, size / 32.0) : 4.0 * size;
}

}  // namespace

CompiledScene::CompiledScene(const VRObject& root, const Illumination& illumination,
                             const BakeSettings& settings, const ObjectSet& found_to_move)
    : watch_(root) {
  nodes_.push_back({nullptr, kWorld});
  t_world_.emplace_back();
  FixedMesh mesh;
  addTree(root, found_to_move, mesh);
  update();
  const std::vector<std::uint32_t> uncut = mesh.indices;
  bake_ = bake(mesh, illumination, settings);
  fixed_.emplace(mesh, uncut, bake_.light, settings.finest);
  bake_.light = {};
  report_.lamps = illumination.lamps.size();
  report_.tolerance = settings.tolerance;
  report(mesh, uncut);
}

void CompiledScene::addTree(const VRObject& root, const ObjectSet& found_to_move, FixedMesh& mesh) {
  struct Pending {
    const VRObject* object;
    TransformMatrix t_world_parent;
  };
  std::vector<Pending> pending{{&root, {}}};
  while (!pending.empty()) {
    const auto [object, t_world_parent] = pending.back();
    pending.pop_back();
    const Mobility mobile = mobility(*object);
    const bool found = mobile == Mobility::Undeclared && found_to_move.contains(object);
    if (found || mobile == Mobility::Moving) {
      addMovingTree(*object, t_world_parent, found);
      continue;
    }
    const TransformMatrix t_world_object = t_world_parent * object->transform();
    addFixed(*object, t_world_object, mesh);
    for (const VRObject* member : object->members()) pending.push_back({member, t_world_object});
  }
}

void CompiledScene::addFixed(const VRObject& object, const TransformMatrix& t_world_object, FixedMesh& mesh) {
  watch_.addFixed(object);
  if (const auto* enclosure = object.attribute<Enclosure>(); enclosure != nullptr)
    enclosures_.push_back({*enclosure, t_world_object});
  const Shows shows = mesh.add(object, t_world_object);
  if (shows == Shows::NoFaces) {
    ++report_.without_faces;
    return;
  }
  CompileReport::Objects& kind = shows == Shows::Faces    ? report_.fixed
                                 : shows == Shows::NoArea ? report_.without_area
                                                          : report_.flat;
  kind.add(object.faces()->faces.size());
  if (shows == Shows::Faces && object.attribute<Fixed>() != nullptr) ++report_.declared_fixed;
}

void CompiledScene::addMovingTree(const VRObject& root, const TransformMatrix& t_world_parent, bool found) {
  if (found) report_.found.push_back(root.path());
  const auto above = count(nodes_);
  nodes_.push_back({nullptr, kWorld});
  t_world_.push_back(t_world_parent);
  nodes_.push_back({&root, above});
  const std::size_t first = moving_.drawables.size();
  // Nodes are appended while the list is walked: breadth first, parents before their members.
  for (std::uint32_t n = above + 1; n < nodes_.size(); ++n) {
    const VRObject& object = *nodes_[n].object;
    watch_.addMoving(object, found && &object == &root);
    if (addMoving(object, n))
      (found ? report_.found_to_move : report_.declared_moving).add(object.faces()->faces.size());
    for (const VRObject* member : object.members()) nodes_.push_back({member, n});
  }
  t_world_.resize(nodes_.size());
  if (moving_.drawables.size() > first) roots_.push_back({above + 1, middleOf(first, above + 1)});
}

/// Of the drawables from `first` on. Three quarters up: light comes from above, and of what stands on a floor
/// or reaches under a table one sees the upper half.
Coord3 CompiledScene::middleOf(std::size_t first, std::uint32_t root) const {
  std::vector<TransformMatrix> t_root{{}};  // T_root_node
  for (std::uint32_t n = root + 1; n < nodes_.size(); ++n)
    t_root.push_back(t_root[nodes_[n].parent - root] * nodes_[n].object->transform());
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (std::size_t d = first; d < moving_.drawables.size(); ++d) {
    const Drawable& drawable = moving_.drawables[d];
    const TransformMatrix& t = t_root[drawable.node - root];
    const glm::dvec3 at = t.point(drawable.origin).glm();
    const glm::dvec3 half = drawable.half_extent.glm();
    glm::dvec3 reach(0.0);
    for (int axis = 0; axis < 3; ++axis) reach += glm::abs(glm::dvec3(t.glm()[axis])) * half[axis];
    low = glm::min(low, at - reach);
    high = glm::max(high, at + reach);
  }
  return Coord3(glm::mix(low, high, glm::dvec3(0.5, 0.75, 0.5)));
}

/// Whether it shows anything.
bool CompiledScene::addMoving(const VRObject& object, std::uint32_t node) {
  if (object.faces() == nullptr) {
    ++report_.without_faces;
    return false;
  }
  Mesh mesh = meshOf(object);
  if (mesh.indices.empty()) {
    report_.without_area.add(object.faces()->faces.size());
    return false;
  }
  const Coord3 half_extent = halfExtent(mesh.vertices);
  refine(mesh, lightingEdge(object, half_extent));
  const auto append = [&](const std::vector<std::uint32_t>& indices) {
    const std::uint32_t first = count(moving_.indices);
    moving_.indices.insert(moving_.indices.end(), indices.begin(), indices.end());
    return first;
  };
  Drawable drawable{{append(mesh.indices), count(mesh.indices), count(moving_.vertices)},
                    object.faces(),
                    node,
                    mesh.origin,
                    half_extent,
                    radius(mesh.vertices),
                    count(roots_),
                    {}};
  for (const MeshLevel& level : mesh.coarser)
    drawable.coarser.push_back({append(level.indices), count(level.indices), level.error});
  moving_.drawables.push_back(std::move(drawable));
  moving_.vertices.insert(moving_.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  return true;
}

void CompiledScene::report(const FixedMesh& mesh, const std::vector<std::uint32_t>& uncut) {
  const auto surfaces = [&](const auto& of, const auto& drawn, std::size_t blocks) {
    report_.bytes += of.vertices.size() * sizeof(of.vertices[0]) + of.indices.size() * sizeof(std::uint32_t);
    std::size_t indices = 0;
    for (const auto& one : drawn) indices += one.range.index_count;
    report_.triangles_coarser += (of.indices.size() - indices) / 3;
    return CompileReport::Surfaces{blocks, indices / 3, of.vertices.size()};
  };
  report_.triangles_before = uncut.size() / 3;
  report_.triangles_cut = mesh.indices.size() / 3;
  report_.lit = surfaces(fixed_->lit, fixed_->lit.blocks, fixed_->lit.blocks.size());
  report_.mapped = surfaces(fixed_->mapped, fixed_->mapped.blocks, fixed_->mapped.blocks.size());
  report_.moving = surfaces(moving_, moving_.drawables, roots_.size());
  report_.charts = fixed_->lightmap.chartCount();
  report_.lightmap_width = fixed_->lightmap.width();
  report_.lightmap_height = fixed_->lightmap.height();
  report_.bytes += fixed_->lightmap.texels().size() * sizeof(PackedLight);
  report_.enclosures = enclosures_.size();
  for (const auto* blocks : {&fixed_->lit.blocks, &fixed_->mapped.blocks})
    for (const Block& block : *blocks)
      report_.largest_radius = std::max(report_.largest_radius, block.radius);
}

void CompiledScene::update() {
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    if (nodes_[n].object != nullptr) t_world_[n] = t_world_[nodes_[n].parent] * nodes_[n].object->transform();
}

Sphere CompiledScene::worldSphere(const Drawable& drawable) const {
  const TransformMatrix& t_world_object = worldTransform(drawable);
  return {t_world_object.point(drawable.origin), t_world_object.maxScale() * drawable.radius};
}

IndexRange CompiledScene::coarsestWithin(double error, const Drawable& drawable) const {
  if (drawable.coarser.empty()) return drawable.range;
  return coherency::coarsestWithin(error / worldTransform(drawable).maxScale(), drawable.range,
                                   drawable.coarser);
}

float CompiledScene::inSight(std::size_t lamp, const Coord3& place) const {
  return bake_.baker->inSight(lamp, glm::vec3((place - bake_.origin).glm()));
}

}  // namespace coherency
