#include <array>
#include <cstring>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "motion_server/broadcast/MotionSender.h"

namespace coherency {
namespace {

constexpr std::int64_t kPeriodNs = 1'000'000;

/// A UDP port of this machine that counts what comes.
class Port {
 public:
  Port() : descriptor_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in any{};
    any.sin_family = AF_INET;
    any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::bind(descriptor_, reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0)
      throw std::runtime_error("no port to be had on loopback");
  }
  ~Port() { ::close(descriptor_); }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  int descriptor() const { return descriptor_; }
  UdpAddress address() const {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    ::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&own), &size);
    UdpAddress address;
    address.size = size;
    std::memcpy(address.bytes.data(), &own, size);
    return address;
  }
  int received() {
    std::array<std::byte, 2048> bytes;
    int count = 0;
    while (::recv(descriptor_, bytes.data(), bytes.size(), MSG_DONTWAIT) > 0) ++count;
    return count;
  }

 private:
  int descriptor_;
};

class MotionSenderTest : public ::testing::Test {
 protected:
  void target(MotionWay way) { sender_.setTargets({{way, client_.address(), counts_}}); }
  /// Sends for so long; what came to the group and to the client alone.
  std::pair<int, int> publish(int milliseconds) {
    std::pair<int, int> came{};
    for (int i = 0; i < milliseconds; ++i) {
      ++sample_.sequence;
      sample_.server_time_ns += kPeriodNs;
      sender_.publish({}, sample_, std::nullopt);
      came.first += group_.received();
      came.second += client_.received();
    }
    return came;
  }

  Port server_, group_, client_;
  KeyframeSource keyframes_;
  MotionSender sender_{{{}, {}, 0, group_.address()}, server_.descriptor(), keyframes_};
  std::shared_ptr<SendCounts> counts_ = std::make_shared<SendCounts>();
  MotionSample sample_{0, 5'000'000'000, 0, 0, {}};
};

TEST_F(MotionSenderTest, SendsToTheGroupOnceWhoeverWantsIt) {
  sender_.setTargets(
      {{MotionWay::Multicast, client_.address(), counts_}, {MotionWay::Multicast, {}, counts_}});
  EXPECT_EQ(publish(50), std::pair(50, 0));
  EXPECT_EQ(counts_->sent, 100U);
}

TEST_F(MotionSenderTest, OffersTheGroupTenTimesASecondWhereNobodyHearsIt) {
  target(MotionWay::Udp);
  EXPECT_EQ(publish(1000), std::pair(10, 1000));
  EXPECT_EQ(counts_->sent, 1000U) << "an offer is nobody's";
}

TEST_F(MotionSenderTest, SendsNothingWhereNobodyIs) {
  EXPECT_EQ(publish(1000), std::pair(0, 0));
}

}  // namespace
}  // namespace coherency
