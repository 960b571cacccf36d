#pragma once

#include "common/scene/Polyhedron.h"

namespace coherency {

/// An upholstered board about the origin: rounded corners, and softened edges on both of its large sides. Far
/// fewer faces than a Loft of the same look, all of them plane. Metres.
class Pad : public Polyhedron {
 public:
  enum class Thick { X, Y, Z };  ///< the axis across the board

  /// `size` along x, y, z, each more than 0.08 except the thickness, which is more than 0.03; otherwise
  /// std::invalid_argument.
  void setSize(const Coord3& size, Thick across);
};

}  // namespace coherency
