#include "render_client/draw/MovingPass.h"

#include <algorithm>
#include <cmath>

#include "render_client/compile/NormalMatrix.h"
#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {

MovingPass::MovingPass(const CompiledScene& scene, std::size_t lamp_count, const ShadowMapSize& shadows)
    : program_(makeProgram("moving", movingVertexShader({LightSource::Lamps, lamp_count, shadows}),
                           fragmentShader({LightSource::Lamps, lamp_count, shadows}))),
      commands_(scene.moving().drawables.size()),
      order_(scene.moving().drawables.size()),
      objects_(scene.moving().drawables.size() * sizeof(Object)) {
  const std::size_t roots = std::max<std::size_t>(scene.movingRoots().size(), 1);
  glNamedBufferStorage(lamp_buffer_.name(), static_cast<GLsizeiptr>(roots * sizeof(LampSet)), nullptr,
                       GL_DYNAMIC_STORAGE_BIT);
  seen_.reserve(scene.moving().drawables.size());
}

void MovingPass::writeLamps(const CompiledScene& scene, const LampSets& lamps) {
  // What lamps that were not chosen would bring comes from above, from everywhere: half of it to a surface
  // that faces none of them in particular.
  constexpr float kOfOthers = 0.5F;
  for (const std::size_t root : lamps.changed()) {
    const ChosenLamps& chosen = lamps.sets()[root];
    const Coord3 place = scene.place(scene.movingRoots()[root]);
    LampSet set{glm::vec4(kOfOthers * chosen.others, 0.0F), {}};
    for (std::size_t i = 0; i < kChosenLamps; ++i) {
      const ChosenLamp& lamp = chosen.lamps[i];
      set.lamps[i] = {glm::vec4(glm::vec3((lamp.position - place).glm()), lamp.reach),
                      glm::vec4(lamp.colour, 0.0F)};
    }
    glNamedBufferSubData(lamp_buffer_.name(), static_cast<GLintptr>(root * sizeof(LampSet)), sizeof(LampSet),
                         &set);
  }
}

void MovingPass::begin(const CompiledScene& scene, const LampSets& lamps, const Coord3& origin,
                       const ViewPyramids& views, const Enclosures& enclosures, const DetailChoice& detail) {
  writeLamps(scene, lamps);
  seen_.clear();
  order_.clear();
  auto* object = objects_.next<Object>();
  const std::vector<Drawable>& drawables = scene.moving().drawables;
  for (std::uint32_t i = 0; i < drawables.size(); ++i) {
    const Turn turn = turnOf(scene.worldTransform(drawables[i]));
    const Sphere sphere = scene.worldSphere(drawables[i]);
    if (turn == Turn::Flat || views.sees(sphere) == InView::None || detail.tooSmall(sphere)) continue;
    const WorldBox box = worldBox(scene, drawables[i]);
    if (enclosures.hide(0.5 * (box.low + box.high), 0.5 * (box.high - box.low))) continue;
    object[seen_.size()] = objectOf(drawables[i], origin, scene);
    order_.add(seen_.size(), farthest(box, origin));
    const IndexRange range = scene.coarsestWithin(detail.allowedError(sphere), drawables[i]);
    seen_.push_back({i, range, turn == Turn::Mirrored});
  }
  order_.sort();
  commands_.begin();
  for (const NearestFirst::Shown& shown : order_.shown()) {
    const auto& [drawable, range, mirrored] = seen_[shown.number];
    commands_.add(range, shown.number, mirrored);
  }
}

MovingPass::Object MovingPass::objectOf(const Drawable& drawable, const Coord3& origin,
                                        const CompiledScene& scene) {
  const glm::dmat4 from_origin = fromEye(origin, scene.worldTransform(drawable), drawable.origin);
  const glm::dmat3 normals = normalMatrix(glm::dmat3(from_origin));
  const Material& material = drawable.faces->material;
  const MovingRoot& root = scene.movingRoots()[drawable.root];
  return {glm::mat4(from_origin),
          glm::vec4(glm::dvec4(normals[0], material.emission)),
          glm::vec4(glm::dvec4(normals[1], 0.0)),
          glm::vec4(glm::dvec4(normals[2], 0.0)),
          glm::vec4(glm::dvec4(material.colour.glm(), material.gloss)),
          glm::vec4(glm::dvec4((scene.place(root) - origin).glm(), drawable.root))};
}

void MovingPass::draw(const SceneBuffers& buffers, const Program* instead) const {
  objects_.bind(GL_SHADER_STORAGE_BUFFER, 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, lamp_buffer_.name());
  buffers.bindMoving();
  glUseProgram((instead == nullptr ? program_ : *instead).name());
  commands_.draw();
}

}  // namespace coherency
