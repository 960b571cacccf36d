#include "motion_server/broadcast/MotionSender.h"

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

namespace coherency {

using boost::asio::ip::udp;

class MotionSender::Impl {
 public:
  Impl(int udp_descriptor, std::uint64_t session_id, int redundancy)
      : redundancy_(static_cast<std::size_t>(redundancy)), socket_(never_run_) {
    const int own = ::dup(udp_descriptor);
    if (own < 0) {
      throw std::runtime_error("cannot duplicate the UDP socket: " + std::string(std::strerror(errno)));
    }
    socket_.assign(udp::v4(), own);  // the protocol is only remembered; the descriptor has its own
    socket_.non_blocking(true);
    packet_.session_id = session_id;
    packet_.previous.reserve(redundancy_ + 1);
  }

  void setTargets(std::vector<MotionTarget> targets) {
    auto fresh = std::make_shared<const std::vector<MotionTarget>>(std::move(targets));
    const std::lock_guard lock(mutex_);
    targets_.swap(fresh);
  }

  void publish(const WorldState& world, const MotionSample& sample) {
    assert(sample.sequence > packet_.sample.sequence);
    remember(sample);
    const auto targets = [this] {
      const std::lock_guard lock(mutex_);
      return targets_;
    }();
    if (targets->empty()) return;
    packet_.world = world;
    packet_.hash = stateHash(world, sample);
    codec_.encode(packet_, datagram_);
    for (const MotionTarget& target : *targets) send(target);
  }

 private:
  /// Makes `sample` the packet's own and the one before it the first of the previous.
  void remember(const MotionSample& sample) {
    if (packet_.sample.sequence != 0) packet_.previous.insert(packet_.previous.begin(), packet_.sample);
    if (packet_.previous.size() > redundancy_) packet_.previous.resize(redundancy_);
    packet_.sample = sample;
  }

  void send(const MotionTarget& target) {
    udp::endpoint to;
    to.resize(target.address.size);
    std::memcpy(to.data(), target.address.bytes.data(), target.address.size);
    boost::system::error_code error;
    socket_.send_to(boost::asio::buffer(datagram_), to, 0, error);
    ++(error ? target.counts->not_sent : target.counts->sent);
  }

  std::size_t redundancy_;
  DatagramCodec codec_;
  MotionPacket packet_;
  std::vector<std::byte> datagram_;
  boost::asio::io_context never_run_{1};  // sends are synchronous: nothing ever waits here
  udp::socket socket_;
  std::mutex mutex_;  // guards targets_ alone
  std::shared_ptr<const std::vector<MotionTarget>> targets_ = std::make_shared<std::vector<MotionTarget>>();
};

MotionSender::MotionSender(int udp_descriptor, std::uint64_t session_id, int redundancy)
    : impl_(std::make_unique<Impl>(udp_descriptor, session_id, redundancy)) {}
MotionSender::~MotionSender() = default;
void MotionSender::setTargets(std::vector<MotionTarget> targets) {
  impl_->setTargets(std::move(targets));
}
void MotionSender::publish(const WorldState& world, const MotionSample& sample) {
  impl_->publish(world, sample);
}

}  // namespace coherency
