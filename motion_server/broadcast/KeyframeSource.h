#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "common/sync/Clock.h"
#include "common/wire/Packets.h"

namespace coherency {

/// Decides which keyframe packets count from. A new one is made where what seldom changes (movables, doors,
/// the task) has changed and the last one is some seconds old; packets count from it when all clients have
/// it, or when those that do not yet have had time enough: they are given it over TCP, which comes in the
/// end, and hold no other back. One thread makes, others ask.
class KeyframeSource {
 public:
  static constexpr std::int64_t kEveryNs = 5'000'000'000;
  static constexpr std::int64_t kPatienceNs = 2'000'000'000;

  /// The one that a packet of this state counts from. The making thread's.
  const Keyframe& current(const WorldState& state, ServerTime now);

  /// What a client needs to have: the one in use, and the one that will be.
  std::vector<Keyframe> needed() const;
  /// The newest there is; 0: none.
  std::uint32_t newest() const;
  /// The newest that every client has.
  void allHave(std::uint32_t number);

 private:
  Keyframe current_;  ///< written by the making thread under mutex_, which reads it without
  mutable std::mutex mutex_;
  std::optional<Keyframe> next_;
  ServerTime made_;
  std::uint32_t all_have_ = 0;
};

}  // namespace coherency
