#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/wire/Discovery.h"

namespace coherency {

struct FoundServer {
  std::string address;  ///< numeric; where its announcement came from
  Announcement announcement;
};

/// Asks on every IPv4 network of this machine, loopback included, which servers there are, and listens for so
/// long. Each server once, by address and port. Nothing of it is proven: it is a hint where to connect.
/// Throws std::runtime_error where no socket can be had.
std::vector<FoundServer> searchServers(std::int64_t listen_ns);

/// One line for people.
std::string describe(const FoundServer& server);

}  // namespace coherency
