#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "common/wire/Packets.h"
#include "motion_server/broadcast/KeyframeSource.h"

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
  MotionWay way = MotionWay::Udp;
  UdpAddress address;  ///< of Udp
  std::shared_ptr<SendCounts> counts;
};

struct MotionSenderConfig {
  SampleForm form;
  Key motion_key{};
  int redundancy = 2;  ///< earlier samples in each packet
  /// Where what Multicast targets want is sent, once; one packet of each 100 ms also where there are none, so
  /// that clients who hear it can become such.
  std::optional<UdpAddress> group;
};

/// Sends motion from the sampling thread, past the thread that serves the sockets: over a descriptor of its
/// own for the same UDP port, so that the two threads share no socket object.
class MotionSender {
 public:
  /// `udp_descriptor` is duplicated; `keyframes` outlive this. Throws std::runtime_error.
  MotionSender(const MotionSenderConfig& config, int udp_descriptor, KeyframeSource& keyframes);
  ~MotionSender();
  MotionSender(const MotionSender&) = delete;
  MotionSender& operator=(const MotionSender&) = delete;

  /// From any thread: whom the next publish() sends to.
  void setTargets(std::vector<MotionTarget> targets);
  /// One thread at a time. `frame`: a new one, where there is one; the packets to come repeat the newest few.
  /// Never blocks; a packet the socket does not take at once is counted and forgotten. True: somebody wants
  /// newestBody().
  bool publish(const WorldState& world, const MotionSample& sample, const std::optional<FrameState>& frame);
  /// What Tcp targets are to be given, not sealed. From any thread.
  std::vector<std::byte> newestBody() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
