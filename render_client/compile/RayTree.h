#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace coherency {

/// Corners, m, counter-clockwise seen from outside.
using RayTriangle = std::array<glm::vec3, 3>;

/// Four numbers side by side, as one instruction takes them.
using Lanes = float __attribute__((vector_size(16)));

/// A bounding volume hierarchy with four children a node (Dammertz, Hanika & Keller 2008) and up to four
/// triangles a leaf, split where the surface area heuristic is least (Wald 2007).
struct RayTree {
  struct Node {
    Lanes bounds[2][3];  ///< low and high of the four children; one that is not there is met by no ray
    std::array<std::int32_t, 4> child;  ///< a node's number; ~ a packet's, where it is a leaf
  };
  struct Packet {
    Lanes corner[3];
    Lanes edge1[3];
    Lanes edge2[3];
    std::array<std::uint32_t, 4> triangle;  ///< their places in what the tree was made of
  };
  /// A walk that goes down first and keeps the other children for later never has more of them to keep.
  static constexpr std::size_t kMaxWaiting = 160;

  std::vector<Node> nodes;  ///< the root is the first; there is one always
  std::vector<Packet> packets;
};

RayTree buildRayTree(const std::vector<RayTriangle>& triangles);

}  // namespace coherency
