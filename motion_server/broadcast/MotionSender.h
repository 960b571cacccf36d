#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/wire/Packets.h"

namespace coherency {

/// A UDP endpoint as the operating system spells it (sockaddr); opaque to all but the sockets.
struct UdpAddress {
  std::array<std::byte, 28> bytes{};
  std::size_t size = 0;
  bool operator==(const UdpAddress&) const = default;
};

struct SendCounts {
  std::atomic<std::uint64_t> sent{0};
  std::atomic<std::uint64_t> not_sent{0};
};

/// Where one client wants its motion.
struct MotionTarget {
  UdpAddress address;
  std::shared_ptr<SendCounts> counts;
};

/// Sends motion from the sampling thread, past the thread that serves the sockets: over a descriptor of its
/// own for the same UDP port, so that the two threads share no socket object.
class MotionSender {
 public:
  /// `udp_descriptor` is duplicated; `session_id` and `redundancy` go into every packet. Throws
  /// std::runtime_error.
  MotionSender(int udp_descriptor, std::uint64_t session_id, int redundancy);
  ~MotionSender();
  MotionSender(const MotionSender&) = delete;
  MotionSender& operator=(const MotionSender&) = delete;

  /// From any thread: whom the next publish() sends to.
  void setTargets(std::vector<MotionTarget> targets);
  /// One thread at a time. Never blocks; a packet the socket does not take at once is counted and forgotten.
  void publish(const WorldState& world, const MotionSample& sample);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
