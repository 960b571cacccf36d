#include "motion_server/broadcast/MotionSender.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <string>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <unistd.h>

#include "common/wire/DatagramCodec.h"
#include "common/wire/SealedDatagram.h"
#include "common/wire/Validity.h"

namespace coherency {

using boost::asio::ip::udp;

namespace {
constexpr std::int64_t kOfferEveryNs = 100'000'000;
}

class MotionSender::Impl {
 public:
  Impl(const MotionSenderConfig& config, int udp_descriptor, KeyframeSource& keyframes)
      : config_(config),
        redundancy_(static_cast<std::size_t>(config.redundancy)),
        keyframes_(keyframes),
        codec_(config.form),
        sealer_(config.motion_key, kMotionChannel),
        socket_(never_run_) {
    const int own = ::dup(udp_descriptor);
    if (own < 0) {
      throw std::runtime_error("cannot duplicate the UDP socket: " + std::string(std::strerror(errno)));
    }
    socket_.assign(udp::v4(), own);  // the protocol is only remembered; the descriptor has its own
    socket_.non_blocking(true);
    packet_.previous.reserve(redundancy_ + 1);
    packet_.frames.reserve(kMaxFrames + 1);
  }

  void setTargets(std::vector<MotionTarget> targets) {
    auto fresh = std::make_shared<const std::vector<MotionTarget>>(std::move(targets));
    const std::lock_guard lock(mutex_);
    targets_.swap(fresh);
  }

  bool publish(const WorldState& world, const MotionSample& sample, const std::optional<FrameState>& frame) {
    assert(sample.sequence > packet_.sample.sequence);
    remember(sample);
    if (frame) remember(*frame);
    const Keyframe& keyframe = keyframes_.current(world, {sample.server_time_ns});
    const auto targets = [this] {
      const std::lock_guard lock(mutex_);
      return targets_;
    }();
    if (targets->empty()) return false;
    packet_.keyframe = keyframe.number;
    packet_.world = world;
    packet_.hash = stateHash(world, sample);
    sealer_.begin(datagram_);
    codec_.encode(packet_, keyframe.world, datagram_);
    const bool tunnels = wants(*targets, MotionWay::Tcp);
    if (tunnels) keepBody();
    sealer_.seal(datagram_);
    send(*targets);
    return tunnels;
  }

  std::vector<std::byte> newestBody() const {
    const std::lock_guard lock(mutex_);
    return body_;
  }

 private:
  static bool wants(const std::vector<MotionTarget>& targets, MotionWay way) {
    return std::any_of(targets.begin(), targets.end(), [&](const MotionTarget& t) { return t.way == way; });
  }

  /// Makes `sample` the packet's own and the one before it the first of the previous.
  void remember(const MotionSample& sample) {
    if (packet_.sample.sequence != 0) packet_.previous.insert(packet_.previous.begin(), packet_.sample);
    if (packet_.previous.size() > redundancy_) packet_.previous.resize(redundancy_);
    packet_.sample = sample;
  }

  /// What has been seen already is of no use any more, but for the newest.
  void remember(const FrameState& frame) {
    packet_.frames.insert(packet_.frames.begin(), frame);
    const ServerTime now{packet_.sample.server_time_ns};
    while (packet_.frames.size() > kMaxFrames ||
           (packet_.frames.size() > 1 && packet_.frames.back().photons() < now))
      packet_.frames.pop_back();
  }

  void keepBody() {
    const auto body = std::span(datagram_).subspan(kSealedHeader);
    const std::lock_guard lock(mutex_);
    body_.assign(body.begin(), body.end());
  }

  void send(const std::vector<MotionTarget>& targets) {
    const bool to_group = config_.group && (wants(targets, MotionWay::Multicast) || offerDue());
    const bool group_sent = to_group && send(*config_.group);
    for (const MotionTarget& target : targets) {
      if (target.way == MotionWay::Tcp) continue;  // counted when it is written
      const bool sent = target.way == MotionWay::Multicast ? group_sent : send(target.address);
      ++(sent ? target.counts->sent : target.counts->not_sent);
    }
  }

  /// Who never hears the group cannot know that it could.
  bool offerDue() {
    if (packet_.sample.server_time_ns - offered_ns_ < kOfferEveryNs) return false;
    offered_ns_ = packet_.sample.server_time_ns;
    return true;
  }

  bool send(const UdpAddress& address) {
    udp::endpoint to;
    to.resize(address.size);
    std::memcpy(to.data(), address.bytes.data(), address.size);
    boost::system::error_code error;
    socket_.send_to(boost::asio::buffer(datagram_), to, 0, error);
    return !error;
  }

  MotionSenderConfig config_;
  std::size_t redundancy_;
  KeyframeSource& keyframes_;
  DatagramCodec codec_;
  DatagramSealer sealer_;
  MotionPacket packet_;
  std::vector<std::byte> datagram_;
  std::int64_t offered_ns_ = 0;
  boost::asio::io_context never_run_{1};  // sends are synchronous: nothing ever waits here
  udp::socket socket_;
  mutable std::mutex mutex_;  // guards targets_ and body_
  std::shared_ptr<const std::vector<MotionTarget>> targets_ = std::make_shared<std::vector<MotionTarget>>();
  std::vector<std::byte> body_;
};

MotionSender::MotionSender(const MotionSenderConfig& config, int udp_descriptor, KeyframeSource& keyframes)
    : impl_(std::make_unique<Impl>(config, udp_descriptor, keyframes)) {}
MotionSender::~MotionSender() = default;
void MotionSender::setTargets(std::vector<MotionTarget> targets) {
  impl_->setTargets(std::move(targets));
}
bool MotionSender::publish(const WorldState& world, const MotionSample& sample,
                           const std::optional<FrameState>& frame) {
  return impl_->publish(world, sample, frame);
}
std::vector<std::byte> MotionSender::newestBody() const {
  return impl_->newestBody();
}

}  // namespace coherency
