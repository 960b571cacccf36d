#include "bench/BarePair.h"

#include <cassert>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

namespace coherency {
namespace {

constexpr int kEnds = 3;  // one of them gets through

int loopbackSocket() {
  const int fd = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (fd < 0 || bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    std::perror("UDP socket on loopback");
    std::exit(1);
  }
  return fd;
}

double quotient(const DurationHistogram& of, const DurationHistogram& to, double q) {
  return static_cast<double>(of.quantile(q)) / static_cast<double>(to.quantile(q));
}

}  // namespace

BarePair::BarePair(std::size_t bytes)
    : receiver_(loopbackSocket()), sender_(loopbackSocket()), datagram_(bytes) {
  assert(bytes >= sizeof(std::int64_t));
  socklen_t length = sizeof to_;
  getsockname(receiver_, reinterpret_cast<sockaddr*>(&to_), &length);
}

BarePair::~BarePair() {
  close(receiver_);
  close(sender_);
}

void BarePair::send(const Clock& clock) {
  const std::int64_t now_ns = clock.nowNs();
  std::memcpy(datagram_.data(), &now_ns, sizeof now_ns);
  sendto(sender_, datagram_.data(), datagram_.size(), 0, reinterpret_cast<const sockaddr*>(&to_), sizeof to_);
}

void BarePair::end() {
  for (int i = 0; i < kEnds; ++i)
    sendto(sender_, datagram_.data(), 0, 0, reinterpret_cast<const sockaddr*>(&to_), sizeof to_);
}

void BarePair::receive(const Clock& clock, DurationHistogram& latency) {
  while (recv(receiver_, datagram_.data(), datagram_.size(), 0) > 0) {
    std::int64_t sent_ns = 0;
    std::memcpy(&sent_ns, datagram_.data(), sizeof sent_ns);
    latency.add(clock.nowNs() - sent_ns);
  }
}

std::string latencyLine(const std::string& what, const DurationHistogram& latency) {
  const Spread us = spread(latency, 1e3);
  return fmt::format("{:<34} p50 {:7.1f} us   p99 {:7.1f} us   max {:8.1f} us   ({} packets)", what, us.p50,
                     us.p99, us.max, latency.count());
}

std::string latencyRatio(const DurationHistogram& of, const DurationHistogram& to) {
  return fmt::format("{:.2f} at the median, {:.2f} at p99", quotient(of, to, 0.5), quotient(of, to, 0.99));
}

}  // namespace coherency
