#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "common/config/SceneFile.h"
#include "common/scene/FaceSet.h"
#include "common/world/Scene.h"

/// The scenes that are shipped, as the tests of this folder ask them.
namespace coherency::scenes {

inline const std::vector<std::string> kShipped = {"laboratory", "corridor", "blocks",
                                                  "look",       "targets",  "grid:100"};

inline SceneDescription described(const std::string& scene) {
  return readScene(scene, COHERENCY_CONFIGS "/scenes");
}

/// Calls visit(object, t_world_object) for everything that is drawn and whose path contains `words`.
template <class Visit>
void forEachDrawn(const VRObject& root, const std::string& words, Visit&& visit) {
  forEachObject(root, {}, [&](const VRObject& object, const TransformMatrix& t_world_object) {
    if (object.faces() != nullptr && object.path().find(words) != std::string::npos)
      visit(object, t_world_object);
  });
}

/// All objects of that name; classes give theirs to each of their instances.
inline std::vector<const VRObject*> called(const VRObject& root, const std::string& name) {
  std::vector<const VRObject*> found;
  forEachObject(root, {}, [&](const VRObject& object, const TransformMatrix&) {
    if (object.name() == name) found.push_back(&object);
  });
  return found;
}

/// Box about what is drawn.
struct Extent {
  Coord3 low{1e9, 1e9, 1e9};
  Coord3 high{-1e9, -1e9, -1e9};

  Coord3 middle() const { return 0.5 * (low + high); }
  void add(const Coord3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

inline Extent extentOf(const VRObject& root, const std::string& words) {
  Extent extent;
  forEachDrawn(root, words, [&](const VRObject& object, const TransformMatrix& t_world_object) {
    for (const Coord3& v : object.faces()->vertices) extent.add(t_world_object.point(v));
  });
  return extent;
}

}  // namespace coherency::scenes
