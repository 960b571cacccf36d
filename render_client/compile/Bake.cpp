#include "render_client/compile/Bake.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "render_client/compile/FixedSurface.h"
#include "render_client/compile/Parallel.h"
#include "render_client/compile/ToneCurve.h"

namespace coherency {
namespace {

/// Longer edges are always looked at; others only where the light differs between their ends.
constexpr double kLookLonger = 0.45;  // m
/// Shadows of rails, shelves and sills are bands. Triangles may grow this long along them, while they are
/// coarse; afterwards none grows longer, so that cutting comes to an end.
constexpr double kStretch = 3.0;
constexpr int kStretchedRounds = 6;

Illumination relativeTo(const Coord3& origin, Illumination illumination) {
  for (Light& lamp : illumination.lamps) lamp.position -= origin;
  return illumination;
}

class Baking {
 public:
  Baking(FixedMesh& mesh, const BakeSettings& settings) : settings_(settings), surface_(mesh) {}

  Bake run(const Illumination& illumination) {
    surface_.cutLongEdges();
    surface_.writeIndices();
    baker_ = std::make_unique<LightBaker>(surface_.occluders(), relativeTo(surface_.origin(), illumination),
                                          settings_.rays);
    light_.resize(surface_.mesh().vertices.size());
    known_.resize(light_.size(), false);
    lightUnknown();
    for (int round = 0; markUneven(); ++round) {
      surface_.cut([this](std::uint32_t side) { addMiddle(side); },
                   round < kStretchedRounds ? kStretch : 0.0);
      lightUnknown();
    }
    surface_.writeIndices();
    unbury();
    return {std::move(light_), surface_.origin(), std::move(baker_)};
  }

 private:
  using Side = Subdivision::Side;

  void addMiddle(std::uint32_t side) {
    const bool known = side < middles_.size() && middles_[side].known;
    light_.push_back(known ? middles_[side].light : SurfaceLight{});
    known_.push_back(known);
  }

  /// A material's own light needs none from elsewhere.
  bool needsLight(std::uint32_t vertex) const {
    return surface_.mesh().objectOf(vertex).object->faces()->material.emission < 1.0;
  }

  void lightUnknown() {
    std::vector<std::uint32_t> unknown;
    for (; lit_ < light_.size(); ++lit_)
      if (!known_[lit_] && needsLight(lit_)) unknown.push_back(lit_);
    parallelFor(unknown.size(),
                [&](std::size_t i) { light_[unknown[i]] = baker_->light(surface_.at(unknown[i])); });
  }

  /// Marks the edges along which light is not as between their ends. Each is looked at once.
  bool markUneven() {
    const std::vector<Side>& sides = surface_.subdivision().sides();
    const std::size_t first = looked_at_;
    const std::vector<std::uint32_t> asked = sidesToAsk();
    middles_.resize(sides.size());
    parallelFor(asked.size(), [&](std::size_t i) {
      middles_[asked[i]] = {true, baker_->light(surface_.halfway(sides[asked[i]]))};
    });
    bool any = false;
    for (std::size_t e = first; e < looked_at_; ++e)
      if (isUneven(surface_.subdivision().edges()[e])) {
        surface_.mark(e);
        any = true;
      }
    return any;
  }

  std::vector<std::uint32_t> sidesToAsk() {
    std::vector<std::uint32_t> asked;
    const Subdivision& subdivision = surface_.subdivision();
    for (; looked_at_ < subdivision.edges().size(); ++looked_at_) {
      const Subdivision::Edge& edge = subdivision.edges()[looked_at_];
      if (edge.isCut() || edge.square <= settings_.finest * settings_.finest) continue;
      for (std::uint32_t s = edge.side; s != Subdivision::kNone; s = subdivision.sides()[s].next)
        if (isWorthALook(subdivision.sides()[s], std::sqrt(edge.square))) asked.push_back(s);
    }
    return asked;
  }

  bool isWorthALook(const Side& side, double length) const {
    if (!std::isfinite(surface_.mesh().objectOf(side.a).longest_edge)) return false;
    const SurfaceLight& a = light_[side.a];
    const SurfaceLight& b = light_[side.b];
    // Between two buried ends, of a strip of wall under a sill, say, there may be what is seen.
    if (length > kLookLonger || a.buried || b.buried) return true;
    return 0.5 * length * shownDifference(side, a.light, b.light) > settings_.tolerance;
  }

  bool isUneven(const Subdivision::Edge& edge) const {
    const std::vector<Side>& sides = surface_.subdivision().sides();
    for (std::uint32_t s = edge.side; s != Subdivision::kNone; s = sides[s].next) {
      if (!middles_[s].known) continue;
      const SurfaceLight& a = light_[sides[s].a];
      const SurfaceLight& b = light_[sides[s].b];
      const SurfaceLight& middle = middles_[s].light;
      if (middle.buried ? a.buried || b.buried : a.buried && b.buried) {
        if (middle.buried) continue;
        return true;
      }
      // Across a shelf's end or a sill light may change at once: it does where that stands, not halfway.
      const double difference = middle.buried ? shownDifference(sides[s], a.light, b.light)
                                              : shownDifference(sides[s], between(sides[s]), middle.light);
      if (difference * std::sqrt(edge.square) > settings_.tolerance) return true;
    }
    return false;
  }

  glm::vec3 between(const Side& side) const {
    const SurfaceLight& a = light_[side.a];
    const SurfaceLight& b = light_[side.b];
    return a.buried ? b.light : b.buried ? a.light : 0.5F * (a.light + b.light);
  }

  /// Of the pictures of a surface in two lights: share of a display's range, in the channel where it is most.
  double shownDifference(const Side& side, const glm::vec3& a, const glm::vec3& b) const {
    const glm::vec3 colour(surface_.mesh().objectOf(side.a).object->faces()->material.colour.glm());
    float most = 0.0F;
    for (int c = 0; c < 3; ++c)
      most = std::max(most, std::abs(encoded(tone(colour[c] * a[c])) - encoded(tone(colour[c] * b[c]))));
    return most;
  }

  /// Gives vertices in the inside of something the light of their neighbours: a floor goes on under a cabinet
  /// as it is beside it.
  void unbury() {
    constexpr int kRings = 8;
    for (int ring = 0; ring < kRings && unburyRing(); ++ring) {
    }
  }

  bool unburyRing() {
    const std::vector<std::uint32_t>& indices = surface_.mesh().indices;
    std::vector<glm::vec3> sums(light_.size(), glm::vec3(0.0F));
    std::vector<float> counts(light_.size(), 0.0F);
    for (std::size_t i = 0; i < indices.size(); ++i)
      for (std::size_t c = i - i % 3; c < i - i % 3 + 3; ++c)
        if (light_[indices[i]].buried && !light_[indices[c]].buried) {
          sums[indices[i]] += light_[indices[c]].light;
          ++counts[indices[i]];
        }
    bool any = false;
    for (std::size_t v = 0; v < light_.size(); ++v)
      if (counts[v] > 0.0F) {
        light_[v] = {sums[v] / counts[v], 0.0F, false};
        any = true;
      }
    return any;
  }

  struct Middle {
    bool known = false;
    SurfaceLight light;
  };

  const BakeSettings settings_;
  FixedSurface surface_;
  std::unique_ptr<LightBaker> baker_;
  std::vector<SurfaceLight> light_;  ///< by vertex
  std::vector<bool> known_;          ///< by vertex
  std::vector<Middle> middles_;      ///< by side
  std::uint32_t lit_ = 0;            ///< vertices before it have their light
  std::size_t looked_at_ = 0;        ///< edges before it have been looked at
};

Bake bakeAlone(const FixedMesh& mesh, const Illumination& illumination) {
  Bake made{std::vector<SurfaceLight>(mesh.vertices.size()), {}, nullptr};
  if (!mesh.objects.empty()) made.origin = mesh.objects.front().origin;
  made.baker =
      std::make_unique<LightBaker>(std::vector<Occluder>{}, relativeTo(made.origin, illumination), 0);
  parallelFor(made.light.size(), [&](std::size_t v) {
    const FixedVertex& vertex = mesh.vertices[v];
    const glm::dvec3 from_origin = (mesh.objects[vertex.object].origin - made.origin).glm();
    made.light[v] = made.baker->light({glm::vec3(from_origin + glm::dvec3(vertex.position)), vertex.normal});
  });
  return made;
}

}  // namespace

Bake bake(FixedMesh& mesh, const Illumination& illumination, const BakeSettings& settings) {
  if (settings.rays == 0) return bakeAlone(mesh, illumination);
  return Baking(mesh, settings).run(illumination);
}

}  // namespace coherency
