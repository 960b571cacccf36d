#include "render_client/compile/SceneWatch.h"

#include "common/scene/FaceSet.h"

namespace coherency {
namespace {

bool needsLight(const VRObject& object) {
  return object.faces() != nullptr && object.faces()->material.emission < 1.0;
}

}  // namespace

SceneWatch::Watch::Watch(const VRObject& object, SceneWatch& scene_, Kind kind_)
    : ObjectWatch(object, kind_ == Kind::Fixed ? Watched::Everything : Watched::AllButMoves),
      kind(kind_),
      has_light(needsLight(object)),
      scene(scene_) {}

void SceneWatch::Watch::changed(ObjectChange change) noexcept {
  if (change == ObjectChange::Repainted) {
    if (kind == Kind::Fixed) scene.noteRepainted(*this);
    return;  // the material of what moves is read in each frame
  }
  if (change == ObjectChange::Moved) kind = Kind::FoundToMove;
  if (change == ObjectChange::Died && object() == scene.root_) scene.root_ = nullptr;
  scene.stale_ = true;
}

void SceneWatch::noteRepainted(Watch& watch) noexcept {
  if (!watch.has_light && needsLight(*watch.object())) stale_ = true;
  if (watch.is_repainted) return;
  watch.is_repainted = true;
  watch.next_repainted = repainted_;
  repainted_ = &watch;
}

ObjectSet SceneWatch::foundToMove() const {
  ObjectSet found;
  for (const Watch& watch : watches_)
    if (watch.kind == Kind::FoundToMove && watch.object() != nullptr) found.insert(watch.object());
  return found;
}

}  // namespace coherency
