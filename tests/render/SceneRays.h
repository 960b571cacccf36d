#pragma once

#include <vector>

#include "common/scene/VRObject.h"
#include "render_client/compile/RayScene.h"

namespace coherency {

/// What shows along a ray, by geometry alone: the first face met from its front. A second way to say what a
/// picture has to show.
class SceneRays {
 public:
  struct Met {
    const VRObject* object = nullptr;  ///< none: nothing
    double distance = 0.0;             ///< m
  };

  /// Through the trees below `roots`, as they now stand.
  explicit SceneRays(const std::vector<const VRObject*>& roots);
  /// `direction`: unit length. Nothing nearer than `from_distance` m.
  Met first(const Coord3& from, const Coord3& direction, double from_distance = 0.0) const;

 private:
  std::vector<const VRObject*> owners_;  ///< by triangle
  RayScene rays_;
};

}  // namespace coherency
