#pragma once

#include <cstdint>
#include <memory>

#include "common/wire/Packets.h"
#include "common/world/Scene.h"

namespace coherency {

/// This machine's copy of the session's world: the scene the server named, in the state of the packet applied
/// last. Built from the session alone, so that two clients cannot differ.
class Replica {
 public:
  /// Throws std::invalid_argument when the session's scene has in it what this client does not know.
  explicit Replica(const SessionConfig& session);

  /// Recomputes the state's hash and, where it is the frame's and the state one of this world's, brings the
  /// scene into that state. Otherwise counts a mismatch, keeps the old state and returns false.
  bool apply(const FrameState& frame);

  /// Goes on with a new session of the same world. Precondition: sameWorld(session, session()).
  void follow(const SessionConfig& session) { session_ = session; }

  const Scene& scene() const { return *scene_; }
  const SessionConfig& session() const { return session_; }
  const MotionSample& sample() const { return frame_.sample; }
  const WorldState& world() const { return frame_.world; }
  std::uint64_t hash() const { return frame_.hash; }
  std::uint64_t frame() const { return frame_.number; }
  std::uint64_t hashMismatches() const { return mismatches_; }

 private:
  SessionConfig session_;
  std::unique_ptr<Scene> scene_;
  FrameState frame_;
  std::uint64_t mismatches_ = 0;
};

/// True if a client of session `a` needs no new replica for session `b`: same scene, same rig.
bool sameWorld(const SessionConfig& a, const SessionConfig& b);

}  // namespace coherency
