#pragma once

#include <cstdint>
#include <string>

namespace coherency {

struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
};

/// HOST, HOST:PORT, [IPV6] or [IPV6]:PORT; the port is `fallback` where none is given. Throws ConfigError.
Endpoint parseEndpoint(const std::string& text, std::uint16_t fallback);

}  // namespace coherency
