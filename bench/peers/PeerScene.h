#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "common/math/TransformMatrix.h"
#include "common/scene/Light.h"
#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/EyeView.h"

namespace coherency {

/// What all peers draw, as plain data: the triangles as this project's renderer has compiled them, object by
/// object, with the light of what never moves. In a file, so that each peer's memory and time are its own.
struct PeerScene {
  struct Fixed {
    Coord3 origin;     ///< of its vertices, m, in the world
    IndexRange range;  ///< its own vertices begin at first_vertex
    std::uint32_t vertex_count = 0;
  };
  /// What never moves, of one kind.
  template <class Vertex>
  struct Surfaces {
    std::vector<Fixed> objects;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
  };
  struct Moving {
    TransformMatrix t_world_mesh;
    glm::vec4 colour_gloss;
    float emission = 0.0F;
    std::uint32_t lamps = 0;  ///< its place in `lamp_sets`
    IndexRange range;
    std::uint32_t vertex_count = 0;
  };
  struct Lamp {
    Coord3 position;  ///< m, in the world
    glm::vec3 colour;
    float reach = 1.0F;  ///< m
    bool operator==(const Lamp&) const = default;
  };
  struct LampSet {
    glm::vec3 others;  ///< light from above, of lamps that were not chosen
    Lamp lamps[4];
    bool operator==(const LampSet&) const = default;
  };

  Surfaces<LitVertex> lit;        ///< `light` is what leaves the surface, its material is in it
  Surfaces<MappedVertex> mapped;  ///< large faces, whose light is a texture
  std::vector<PackedLight> lightmap;
  glm::ivec2 lightmap_size{0};
  std::vector<Moving> moving;
  std::vector<MeshVertex> moving_vertices;
  std::vector<std::uint32_t> moving_indices;
  std::vector<LampSet> lamp_sets;
  std::vector<EyeView> views;  ///< of the frames of the camera's path
  Ambient ambient;
  std::uint32_t lamp_count = 0;  ///< of each set's lamps, those the shader needs to look at
  bool on_the_way = false;       ///< what moves does, by movingPose(), and is seen from its middle
};

/// Throw std::runtime_error naming the file.
void writePeerScene(const PeerScene& scene, const std::filesystem::path& path);
PeerScene readPeerScene(const std::filesystem::path& path);

}  // namespace coherency
