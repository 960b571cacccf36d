#pragma once

#include <array>

#include "common/body/Loft.h"
#include "common/body/Rig.h"
#include "common/scene/Primitives.h"

namespace coherency {

/// How much larger than the default rig's the skull must be to hold the eyes.
double headScale(const Rig& rig);

/// Head and neck in the head frame, seen from outside. The eye points of the rig lie inside the convex skull,
/// and faces are seen from outside only: the operator's own eyes see through the head as if it were not
/// there, everybody else, lamps included, sees it.
class HeadShape : public VRObject {
 public:
  explicit HeadShape(const Rig& rig);

 private:
  void buildSkull(const Rig& rig);
  void buildFace(const Rig& rig);

  Loft skull_;
  Loft hair_;
  Loft neck_;
  Ellipsoid nose_;
  Ellipsoid mouth_;
  std::array<Ellipsoid, 2> ears_;
};

}  // namespace coherency
