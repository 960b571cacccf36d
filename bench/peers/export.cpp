// Writes a scene as this project's renderer compiles it, for the peers to draw.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <unordered_map>
#include <utility>

#include <CLI/CLI.hpp>

#include "bench/peers/PeerScene.h"
#include "bench/peers/PeerWorld.h"
#include "render_client/compile/NormalMatrix.h"
#include "render_client/draw/LampSets.h"

namespace {

using namespace coherency;

/// In place of what falls on a surface what it sends to the eye.
LitVertex leaving(LitVertex vertex) {
  const double emission = vertex.material.share[3] / 255.0;
  for (int channel = 0; channel < 3; ++channel) {
    const double root = vertex.material.share[channel] / 255.0;
    const double falling = vertex.light.share[channel] / 65535.0;
    const double light = root * root * std::lerp(falling, 1.0 / PackedLight::kBrightest, emission);
    vertex.light.share[channel] = static_cast<std::uint16_t>(std::lround(65535.0 * light));
  }
  return vertex;
}

/// Objects instead of blocks: to put them together is each peer's own affair.
template <class Vertex>
PeerScene::Surfaces<Vertex> apart(const BlockSurfaces<Vertex>& from) {
  PeerScene::Surfaces<Vertex> to{{}, from.vertices, from.indices};
  for (const BlockPart& part : from.parts) {
    if (part.vertex_count == 0) continue;  // in a coarser level
    const Block& block = from.blocks[part.block];
    to.objects.push_back({block.origin, part.range, part.vertex_count});
    const std::uint32_t before = part.range.first_vertex - block.range.first_vertex;
    for (std::uint32_t i = 0; i < part.range.index_count; ++i)
      to.indices[part.range.first_index + i] -= before;
  }
  return to;
}

void addFixed(const FixedBlocks& fixed, PeerScene& scene) {
  scene.lit = apart(fixed.lit);
  for (LitVertex& vertex : scene.lit.vertices) vertex = leaving(vertex);
  scene.mapped = apart(fixed.mapped);
  scene.lightmap = fixed.lightmap.texels();
  scene.lightmap_size = {fixed.lightmap.width(), fixed.lightmap.height()};
}

/// The number of that set among those of the scene, to which it is added where it is new.
std::uint32_t addLamps(const ChosenLamps& chosen, PeerScene& scene) {
  PeerScene::LampSet set{chosen.others, {}};
  for (std::size_t i = 0; i < kChosenLamps; ++i)
    set.lamps[i] = {chosen.lamps[i].position, chosen.lamps[i].colour, chosen.lamps[i].reach};
  // In an order of their own: places that differ in which lamp is nearest may share a set.
  std::sort(std::begin(set.lamps), std::end(set.lamps), [](const auto& a, const auto& b) {
    return std::pair{a.position.x, a.position.z} < std::pair{b.position.x, b.position.z};
  });
  const auto same = std::find(scene.lamp_sets.begin(), scene.lamp_sets.end(), set);
  const auto number = static_cast<std::uint32_t>(same - scene.lamp_sets.begin());
  if (same == scene.lamp_sets.end()) scene.lamp_sets.push_back(set);
  return number;
}

void addMoving(const CompiledScene& compiled, const LampSets& lamps, PeerScene& scene) {
  const MovingSurfaces& from = compiled.moving();
  scene.moving_vertices = from.vertices;
  scene.moving_indices = from.indices;
  for (std::size_t d = 0; d < from.drawables.size(); ++d) {
    const Drawable& drawable = from.drawables[d];
    const std::size_t end =
        d + 1 < from.drawables.size() ? from.drawables[d + 1].range.first_vertex : from.vertices.size();
    const Material& material = drawable.faces->material;
    const TransformMatrix& t_world_object = compiled.worldTransform(drawable);
    const Turn turn = turnOf(t_world_object);
    if (turn == Turn::Flat) continue;
    for (std::uint32_t i = 0; turn == Turn::Mirrored && i < drawable.range.index_count; i += 3)
      std::swap(scene.moving_indices[drawable.range.first_index + i],
                scene.moving_indices[drawable.range.first_index + i + 1]);
    scene.moving.push_back({t_world_object * TransformMatrix::translation(drawable.origin),
                            glm::vec4(glm::dvec4(material.colour.glm(), material.gloss)),
                            static_cast<float>(material.emission),
                            addLamps(lamps.sets()[drawable.root], scene), drawable.range,
                            static_cast<std::uint32_t>(end - drawable.range.first_vertex)});
  }
}

/// movingPose() goes by the order of the members, and CompiledScene has its own.
void orderMoving(const PeerWorld& world, const CompiledScene& compiled, PeerScene& scene) {
  std::unordered_map<const FaceSet*, std::size_t> numbers;
  for (const VRObject* box : world.root().members()) numbers.emplace(box->faces(), numbers.size());
  std::vector<PeerScene::Moving> ordered(scene.moving.size());
  for (std::size_t i = 0; i < ordered.size(); ++i)
    ordered[numbers.at(compiled.moving().drawables[i].faces)] = scene.moving[i];
  scene.moving = std::move(ordered);
}

PeerScene exported(const PeerWorld& world, const BakeSettings& bake) {
  const CompiledScene compiled(world.root(), world.illumination(), bake);
  LampSets lamps(world.illumination(), compiled);
  lamps.update();
  PeerScene scene;
  addFixed(compiled.fixed(), scene);
  addMoving(compiled, lamps, scene);
  if (world.moves()) orderMoving(world, compiled, scene);
  for (int frame = 0; frame < kPathFrames; ++frame) scene.views.push_back(world.view(frame));
  scene.ambient = world.illumination().ambient;
  scene.lamp_count = static_cast<std::uint32_t>(std::min(world.illumination().lamps.size(), kChosenLamps));
  scene.on_the_way = world.moves();
  return scene;
}

std::size_t triangles(const auto& objects) {
  std::size_t count = 0;
  for (const auto& object : objects) count += object.range.index_count / 3;
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes a scene's triangles, their light and the camera's path, for the peers.",
               "peer_export");
  PeerWorldOptions options;
  std::string file;
  options.addTo(app);
  app.add_option("file", file, "To be written")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    const PeerScene scene = exported(PeerWorld(options), options.bake);
    writePeerScene(scene, file);
    std::printf("%zu fixed, %zu moving, %zu triangles, %zu sets of lamps\n",
                scene.lit.objects.size() + scene.mapped.objects.size(), scene.moving.size(),
                triangles(scene.lit.objects) + triangles(scene.mapped.objects) + triangles(scene.moving),
                scene.lamp_sets.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer_export: %s\n", error.what());
    return 1;
  }
  return 0;
}
