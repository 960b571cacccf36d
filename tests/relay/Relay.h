#pragma once

#include <string>

#include "tests/relay/Options.h"
#include "tests/relay/TcpRelay.h"
#include "tests/relay/UdpRelay.h"

namespace coherency {

/// Both relays under one set of settings, as a test script directs them.
class Relay {
 public:
  /// As UdpRelay's and TcpRelay's constructors.
  Relay(boost::asio::io_context& io, const RelayOptions& options, const Clock& clock);

  /// Does what a line says: NAME VALUE of a setting, "impair on", "impair off" (the settings are kept for the
  /// next "on"), "cut", "stats". The answer is "ok", the statistics, or "error: " and what is wrong.
  std::string obey(const std::string& line);
  /// On one line; times in ms.
  std::string statsJson() const;

 private:
  void apply();

  RelaySettings settings_;
  bool impairing_ = true;
  UdpRelay udp_;
  TcpRelay tcp_;
};

}  // namespace coherency
