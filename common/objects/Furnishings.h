#pragma once

#include <array>
#include <cstdint>

#include "common/objects/Faces.h"
#include "common/scene/Primitives.h"

// Small things that stand on furniture or beside it. Origins at the bottom, facing +z. Metres.

namespace coherency {

/// Cube to build with; its origin is its centre.
class Block : public VRObject {
 public:
  static constexpr double kEdge = 0.055;

  Block(const std::string& name, std::uint32_t colour);

 private:
  Box cube_;
};

class Mug : public VRObject {
 public:
  explicit Mug(std::uint32_t colour);

 private:
  Cylinder cup_;
  Cylinder coffee_;
  Box handle_;
};

class Globe : public VRObject {
 public:
  Globe();

 private:
  Cylinder foot_;
  Cylinder stem_;
  Ellipsoid ball_;
};

class ToolBox : public VRObject {
 public:
  explicit ToolBox(std::uint32_t colour);

 private:
  Polyhedron case_;
  Polyhedron handle_;
};

class WasteBin : public VRObject {
 public:
  WasteBin();

 private:
  Cylinder bin_;
  Cylinder inside_;
};

/// A few books and papers that lie on one another.
class PaperPile : public VRObject {
 public:
  PaperPile();

 private:
  std::array<Box, 3> books_;
  Box sheet_;
};

}  // namespace coherency
