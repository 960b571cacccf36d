#include "render_client/replica/Replica.h"

namespace coherency {

Replica::Replica(const SessionConfig& session)
    : session_(session), scene_(std::make_unique<Scene>(session.scene, session.rig)) {}

bool Replica::apply(const MotionPacket& packet) {
  const std::uint64_t hash = stateHash(packet.world, packet.sample);
  if (hash != packet.hash || !scene_->fits(packet.world)) {
    ++mismatches_;
    return false;
  }
  hash_ = hash;
  sample_ = packet.sample;
  world_ = packet.world;
  scene_->apply(world_, sample_);
  return true;
}

bool sameWorld(const SessionConfig& a, const SessionConfig& b) {
  if (a.scene != b.scene) return false;
  for (const RigField& field : rigFields())
    if (a.rig.*field.value != b.rig.*field.value) return false;
  return true;
}

}  // namespace coherency
