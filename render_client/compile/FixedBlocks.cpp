#include "render_client/compile/FixedBlocks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_client/compile/Grouping.h"

namespace coherency {
namespace {

using Triangles = std::vector<std::uint32_t>;
using Levels = std::vector<std::vector<MeshLevel>>;  // by object

std::uint32_t count(const auto& list) {
  return static_cast<std::uint32_t>(list.size());
}

std::uint8_t byte(double of_one) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(of_one, 0.0, 1.0) * 255.0));
}

glm::dvec3 inWorld(const FixedMesh& mesh, std::uint32_t vertex) {
  return mesh.objectOf(vertex).origin.glm() + glm::dvec3(mesh.vertices[vertex].position);
}

/// Puts triangles of one kind, object by object, into blocks.
template <class Vertex>
class BlockBuilder {
 public:
  BlockBuilder(const FixedMesh& mesh, const Triangles& triangles, const Levels& levels)
      : mesh_(mesh), triangles_(triangles), levels_(levels), place_(mesh.vertices.size(), kNowhere) {}

  /// shaded(v): whether something could be in shadow at a vertex; write(v, to): all but its position and
  /// material.
  template <class Shaded, class Write>
  BlockSurfaces<Vertex> build(const Shaded& shaded, const Write& write) {
    for (const bool wanted : {false, true}) {
      findItems(shaded, wanted);
      for (const std::vector<std::uint32_t>& members :
           group(boxes_, FixedBlocks::kBlockTriangles, FixedBlocks::kBlockSize))
        addBlock(members, wanted, write);
    }
    orderByObject();
    return std::move(surfaces_);
  }

 private:
  static constexpr std::uint32_t kNowhere = UINT32_MAX;
  struct Item {  ///< an object's triangles, in triangles_
    std::size_t first, end;
  };

  template <class Shaded>
  void findItems(const Shaded& shaded, bool wanted) {
    items_.clear();
    boxes_.clear();
    for (std::size_t i = 0; i < triangles_.size();) {
      const std::uint32_t object = mesh_.vertices[triangles_[i]].object;
      const glm::dvec3 start = inWorld(mesh_, triangles_[i]);
      GroupItem box{start, start, 0};
      bool is_shaded = false;
      const std::size_t first = i;
      for (; i < triangles_.size() && mesh_.vertices[triangles_[i]].object == object; ++i) {
        box.low = glm::min(box.low, inWorld(mesh_, triangles_[i]));
        box.high = glm::max(box.high, inWorld(mesh_, triangles_[i]));
        is_shaded = is_shaded || shaded(triangles_[i]);
      }
      if (is_shaded != wanted) continue;
      box.triangles = static_cast<std::uint32_t>((i - first) / 3);
      items_.push_back({first, i});
      boxes_.push_back(box);
    }
  }

  template <class Write>
  void addBlock(const std::vector<std::uint32_t>& members, bool shaded, const Write& write) {
    glm::dvec3 low = boxes_[members.front()].low;
    glm::dvec3 high = boxes_[members.front()].high;
    for (const std::uint32_t item : members) {
      low = glm::min(low, boxes_[item].low);
      high = glm::max(high, boxes_[item].high);
    }
    Block block{{count(surfaces_.indices), 0, count(surfaces_.vertices)},
                Coord3(0.5 * (low + high)),
                {},
                0.0,
                shaded,
                {}};
    for (const std::uint32_t item : members) addPart(items_[item], block, write);
    block.range.index_count = count(surfaces_.indices) - block.range.first_index;
    addLevels(members, block);
    measure(block);
    surfaces_.blocks.push_back(block);
  }

  template <class Write>
  void addPart(const Item& item, const Block& block, const Write& write) {
    const FixedObject& object = mesh_.objectOf(triangles_[item.first]);
    const std::uint32_t first_index = count(surfaces_.indices);
    const std::uint32_t first_vertex = count(surfaces_.vertices);
    const auto addVertex = [&](std::uint32_t v) {
      if (place_[v] != kNowhere) return;
      place_[v] = count(surfaces_.vertices) - block.range.first_vertex;
      const glm::vec3 at(inWorld(mesh_, v) - block.origin.glm());
      Vertex vertex{{at.x, at.y, at.z}, {}, materialOf(object.object->faces()->material)};
      write(v, vertex);
      surfaces_.vertices.push_back(vertex);
    };
    for (const std::uint32_t v : trianglesOf(item)) {
      addVertex(v);
      surfaces_.indices.push_back(place_[v]);
    }
    for (const MeshLevel& level : levelsOf(item))
      for (const std::uint32_t v : level.indices) addVertex(v);
    surfaces_.parts.push_back({object.object,
                               count(surfaces_.blocks),
                               count(surfaces_.vertices) - first_vertex,
                               {first_index, count(surfaces_.indices) - first_index, first_vertex}});
  }

  void orderByObject() {
    std::vector<std::uint32_t>& places = surfaces_.by_object;
    places.resize(surfaces_.parts.size());
    std::iota(places.begin(), places.end(), 0U);
    const auto object = [this](std::uint32_t place) { return surfaces_.parts[place].object; };
    std::ranges::sort(places, std::less<>(), object);
  }

  std::span<const std::uint32_t> trianglesOf(const Item& item) const {
    return std::span(triangles_).subspan(item.first, item.end - item.first);
  }
  const std::vector<MeshLevel>& levelsOf(const Item& item) const {
    return levels_[mesh_.vertices[triangles_[item.first]].object];
  }

  void addLevelPart(const Item& item, std::span<const std::uint32_t> triangles) {
    surfaces_.parts.push_back({mesh_.objectOf(triangles_[item.first]).object,
                               count(surfaces_.blocks),
                               0,
                               {count(surfaces_.indices), count(triangles), 0}});
    for (const std::uint32_t v : triangles) surfaces_.indices.push_back(place_[v]);
  }

  void removeFrom(std::uint32_t first_index) {
    surfaces_.indices.resize(first_index);
    while (surfaces_.parts.back().range.first_index >= first_index) surfaces_.parts.pop_back();
  }

  void addLevels(const std::vector<std::uint32_t>& members, Block& block) {
    if (std::ranges::all_of(members, [&](std::uint32_t item) { return levelsOf(items_[item]).empty(); }))
      return;
    std::uint32_t finer = block.range.index_count;
    for (const double allowed : FixedBlocks::kLevelErrors) {
      LevelRange level{count(surfaces_.indices), 0, 0.0};
      for (const std::uint32_t item : members) {
        std::span<const std::uint32_t> coarsest = trianglesOf(items_[item]);
        for (const MeshLevel& own : levelsOf(items_[item])) {
          if (own.error > allowed) break;
          coarsest = own.indices;
          level.error = std::max(level.error, own.error);
        }
        addLevelPart(items_[item], coarsest);
      }
      level.index_count = count(surfaces_.indices) - level.first_index;
      if (level.index_count < finer)
        block.coarser.push_back(level);
      else
        removeFrom(level.first_index);
      finer = level.index_count;
    }
  }

  /// By the vertices as they are drawn.
  void measure(Block& block) const {
    glm::dvec3 extent(0.0);
    double square = 0.0;
    for (std::size_t v = block.range.first_vertex; v < surfaces_.vertices.size(); ++v) {
      const float(&p)[3] = surfaces_.vertices[v].position;
      const glm::dvec3 at(p[0], p[1], p[2]);
      extent = glm::max(extent, glm::abs(at));
      square = std::max(square, glm::dot(at, at));
    }
    block.half_extent = Coord3(extent);
    block.radius = std::sqrt(square);
  }

  const FixedMesh& mesh_;
  const Triangles& triangles_;
  const Levels& levels_;
  Triangles place_;  ///< by vertex of the mesh: in its block
  std::vector<Item> items_;
  std::vector<GroupItem> boxes_;
  BlockSurfaces<Vertex> surfaces_;
};

Triangles trianglesWhere(const Triangles& all, const auto& wanted) {
  Triangles some;
  for (std::size_t i = 0; i + 2 < all.size(); i += 3)
    if (wanted(all[i])) some.insert(some.end(), {all[i], all[i + 1], all[i + 2]});
  return some;
}

template <class Vertex>
void repaintIn(BlockSurfaces<Vertex>& surfaces, const VRObject& object) {
  for (const std::uint32_t place : surfaces.partsOf(object)) {
    const BlockPart& part = surfaces.parts[place];
    for (std::uint32_t v = 0; v < part.vertex_count; ++v)
      surfaces.vertices[part.range.first_vertex + v].material = materialOf(object.faces()->material);
  }
}

std::vector<std::size_t> countByObject(const FixedMesh& mesh, const Triangles& indices) {
  std::vector<std::size_t> counts(mesh.objects.size(), 0);
  for (const std::uint32_t v : indices) ++counts[mesh.vertices[v].object];
  return counts;
}

/// What of the objects' coarser levels has its light at its vertices. None of an object that was cut for its
/// light: over the vertices that were there before, a coarser one would show less of it. Nor any with a
/// triangle that has corners of both kinds.
Levels levelsWithLight(const FixedMesh& mesh, const Triangles& cut, const Triangles& uncut,
                       const auto& has_light) {
  const std::vector<std::size_t> before = countByObject(mesh, uncut);
  const std::vector<std::size_t> after = countByObject(mesh, cut);
  const auto mixed = [&](const Triangles& level) {
    for (std::size_t i = 0; i < level.size(); ++i)
      if (has_light(level[i]) != has_light(level[i - i % 3])) return true;
    return false;
  };
  Levels all(mesh.objects.size());
  for (std::size_t object = 0; object < all.size(); ++object)
    for (const MeshLevel& level : mesh.objects[object].coarser)
      if (after[object] == before[object] && !mixed(level.indices))
        all[object].push_back({trianglesWhere(level.indices, has_light), level.error});
  return all;
}

}  // namespace

template <class Vertex>
std::span<const std::uint32_t> BlockSurfaces<Vertex>::partsOf(const VRObject& object) const {
  const auto before = [this](std::uint32_t place, const VRObject* of) {
    return std::less<>()(parts[place].object, of);
  };
  const auto first = std::lower_bound(by_object.begin(), by_object.end(), &object, before);
  auto last = first;
  while (last != by_object.end() && parts[*last].object == &object) ++last;
  return {first, last};
}
template struct BlockSurfaces<LitVertex>;
template struct BlockSurfaces<MappedVertex>;

PackedMaterial materialOf(const Material& material) {
  const auto root = [](double share) { return byte(std::sqrt(std::max(share, 0.0))); };
  return {
      {root(material.colour.x), root(material.colour.y), root(material.colour.z), byte(material.emission)}};
}

FixedBlocks::FixedBlocks(const FixedMesh& mesh, const Triangles& uncut,
                         const std::vector<SurfaceLight>& light, double finest)
    : lightmap(mesh, uncut, light, finest), object_count(mesh.objects.size()) {
  const auto has_light = [&](std::uint32_t v) { return !lightmap.has(v); };  // at its vertices
  const auto is_mapped = [&](std::uint32_t v) { return lightmap.has(v); };
  const Triangles with_light = trianglesWhere(mesh.indices, has_light);
  const Levels levels = levelsWithLight(mesh, with_light, trianglesWhere(uncut, has_light), has_light);
  lit = BlockBuilder<LitVertex>(mesh, with_light, levels)
            .build([&](std::uint32_t v) { return light[v].shade > kWorthShading; },
                   [&](std::uint32_t v, LitVertex& vertex) { vertex.light = packed(light[v]); });
  // Where a cap is mapped and its side is not, the cap keeps its corners.
  const Triangles flat = trianglesWhere(uncut, is_mapped);
  mapped = BlockBuilder<MappedVertex>(mesh, flat, Levels(mesh.objects.size()))
               .build([&](std::uint32_t v) { return lightmap.isShaded(v); },
                      [&](std::uint32_t v, MappedVertex& vertex) {
                        const glm::vec2 place = lightmap.place(mesh, v);
                        vertex.place = {place.x, place.y};
                      });
}

void FixedBlocks::repaint(const VRObject& object) {
  repaintIn(lit, object);
  repaintIn(mapped, object);
}

}  // namespace coherency
