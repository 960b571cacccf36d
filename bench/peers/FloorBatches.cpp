#include "bench/peers/FloorBatches.h"

#include "render_client/compile/NormalMatrix.h"

namespace coherency {
namespace {

/// Lamps are from the eye, so that is the place for which all were chosen.
FloorObject floorObject(const PeerScene::Moving& object, const Coord3& eye) {
  const glm::dmat4 from_eye = (TransformMatrix::translation(-eye) * object.t_world_mesh).glm();
  const glm::dmat3 normals = normalMatrix(glm::dmat3(from_eye));
  return {glm::mat4(from_eye),
          glm::vec4(glm::dvec4(normals[0], object.emission)),
          glm::vec4(glm::dvec4(normals[1], 0.0)),
          glm::vec4(glm::dvec4(normals[2], 0.0)),
          object.colour_gloss,
          glm::vec4(0.0F, 0.0F, 0.0F, static_cast<float>(object.lamps))};
}

FloorLampSet lampSet(const PeerScene::LampSet& from, const Coord3& eye) {
  FloorLampSet set{glm::vec4(0.5F * from.others, 0.0F), {}};
  for (std::size_t i = 0; i < 4; ++i) {
    const PeerScene::Lamp& lamp = from.lamps[i];
    set.lamps[i] = {glm::vec4(glm::vec3((lamp.position - eye).glm()), lamp.reach),
                    glm::vec4(lamp.colour, 0.0F)};
  }
  return set;
}

}  // namespace

template <class Vertex>
FixedBatch<Vertex> fixedInView(const PeerScene::Surfaces<Vertex>& from, const EyeView& view) {
  const Coord3 eye = view.t_world_eye.origin();
  const TransformMatrix t_eye_world = view.t_world_eye.rigidInverse();
  FixedBatch<Vertex> made;
  std::vector<std::uint32_t>& indices = made.batch.indices;
  const auto origin = [&](const PeerScene::Fixed& object) {
    const auto& p = from.vertices[object.range.first_vertex].position;
    return object.origin + Coord3{p[0], p[1], p[2]};
  };
  for (const std::size_t number : nearestFirst(from.objects, origin, eye)) {
    const PeerScene::Fixed& object = from.objects[number];
    const Vertex* own = &from.vertices[object.range.first_vertex];
    const std::size_t first = indices.size();
    appendSeen({view, t_eye_world * TransformMatrix::translation(object.origin)}, own,
               {&from.indices[object.range.first_index], object.range.index_count}, indices);
    if (indices.size() == first) continue;
    const auto before = static_cast<std::uint32_t>(made.vertices.size());
    for (std::size_t i = first; i < indices.size(); ++i) indices[i] += before;
    const glm::vec3 offset((object.origin - eye).glm());
    for (std::uint32_t v = 0; v < object.vertex_count; ++v) {
      made.vertices.push_back(own[v]);
      for (int axis = 0; axis < 3; ++axis) made.vertices.back().position[axis] += offset[axis];
    }
  }
  if (!indices.empty()) made.batch.commands = {{static_cast<GLuint>(indices.size()), 1, 0, 0, 0}};
  return made;
}

template <class Vertex>
void compact(FixedBatch<Vertex>& made) {
  constexpr std::uint32_t kNowhere = UINT32_MAX;
  std::vector<std::uint32_t> place(made.vertices.size(), kNowhere);
  std::vector<Vertex> kept;
  for (std::uint32_t& index : made.batch.indices) {
    if (place[index] == kNowhere) {
      place[index] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(made.vertices[index]);
    }
    index = place[index];
  }
  made.vertices = std::move(kept);
}

template FixedBatch<LitVertex> fixedInView(const PeerScene::Surfaces<LitVertex>&, const EyeView&);
template FixedBatch<MappedVertex> fixedInView(const PeerScene::Surfaces<MappedVertex>&, const EyeView&);
template void compact(FixedBatch<LitVertex>&);
template void compact(FixedBatch<MappedVertex>&);

MovingBatch movingInView(const PeerScene& scene, const EyeView& view) {
  const Coord3 eye = view.t_world_eye.origin();
  const TransformMatrix t_eye_world = view.t_world_eye.rigidInverse();
  MovingBatch made;
  made.objects.resize(scene.moving.size());
  const auto origin = [](const PeerScene::Moving& object) { return object.t_world_mesh.origin(); };
  for (const std::size_t number : nearestFirst(scene.moving, origin, eye)) {
    const PeerScene::Moving& object = scene.moving[number];
    const auto first = static_cast<GLuint>(made.batch.indices.size());
    appendSeen({view, t_eye_world * object.t_world_mesh}, &scene.moving_vertices[object.range.first_vertex],
               {&scene.moving_indices[object.range.first_index], object.range.index_count},
               made.batch.indices);
    const auto count = static_cast<GLuint>(made.batch.indices.size()) - first;
    if (count == 0) continue;
    made.batch.commands.push_back(
        {count, 1, first, static_cast<GLint>(object.range.first_vertex), static_cast<GLuint>(number)});
    made.objects[number] = floorObject(object, eye);
  }
  for (const PeerScene::LampSet& set : scene.lamp_sets) made.lamp_sets.push_back(lampSet(set, eye));
  return made;
}

}  // namespace coherency
