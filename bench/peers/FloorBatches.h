#pragma once

#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

#include "bench/peers/FloorPass.h"
#include "bench/peers/PeerScene.h"
#include "bench/peers/SeenTriangles.h"

namespace coherency {

// What the floor draws of a frame, found beforehand: triangles that are not wholly beside the view, objects
// nearest first.

/// What never moves, as one command; `vertices` are relative to the eye.
template <class Vertex>
struct FixedBatch {
  std::vector<Vertex> vertices;
  FloorBatch batch;
};
template <class Vertex>
FixedBatch<Vertex> fixedInView(const PeerScene::Surfaces<Vertex>& from, const EyeView& view);

/// Leaves out the vertices that no triangle has.
template <class Vertex>
void compact(FixedBatch<Vertex>& made);

/// As the shader has it (std430).
struct FloorObject {
  glm::mat4 world_from_mesh;
  glm::vec4 normal_x_emission;
  glm::vec4 normal_y;
  glm::vec4 normal_z;
  glm::vec4 colour_gloss;
  glm::vec4 place_root;
};
struct FloorLampSet {
  glm::vec4 others;
  struct {
    glm::vec4 position_reach;
    glm::vec4 colour;
  } lamps[4];
};

/// What moves, a command each; all is relative to the eye.
struct MovingBatch {
  FloorBatch batch;
  std::vector<FloorObject> objects;
  std::vector<FloorLampSet> lamp_sets;
};
MovingBatch movingInView(const PeerScene& scene, const EyeView& view);

}  // namespace coherency
