#include "render_client/replica/Replica.h"

#include "common/wire/Validity.h"

namespace coherency {

Replica::Replica(const SessionConfig& session)
    : session_(session), scene_(std::make_unique<Scene>(session.scene, session.rig)) {}

bool Replica::apply(const FrameState& frame) {
  if (!hashHolds(frame) || !scene_->fits(frame.world)) {
    ++mismatches_;
    return false;
  }
  frame_ = frame;
  scene_->apply(frame_.world, frame_.sample);
  return true;
}

bool sameWorld(const SessionConfig& a, const SessionConfig& b) {
  if (a.scene != b.scene) return false;
  for (const RigField& field : rigFields())
    if (a.rig.*field.value != b.rig.*field.value) return false;
  return true;
}

}  // namespace coherency
