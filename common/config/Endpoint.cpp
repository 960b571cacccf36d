#include "common/config/Endpoint.h"

#include <charconv>

#include <fmt/format.h>

#include "common/config/ConfigError.h"

namespace coherency {

Endpoint parseEndpoint(const std::string& text, std::uint16_t fallback) {
  const ConfigError wrong(
      fmt::format("\"{}\" is no HOST:PORT; right would be 192.0.2.1:{}, name:{} or [::1]:{}", text, fallback,
                  fallback, fallback));
  Endpoint endpoint{text, fallback};
  std::string port;
  if (text.starts_with('[')) {
    const auto close = text.find(']');
    if (close == std::string::npos) throw wrong;
    endpoint.host = text.substr(1, close - 1);
    if (close + 1 < text.size()) {
      if (text[close + 1] != ':') throw wrong;
      port = text.substr(close + 2);
      if (port.empty()) throw wrong;
    }
  } else if (const auto colon = text.rfind(':'); colon != std::string::npos) {
    endpoint.host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (port.empty() || endpoint.host.find(':') != std::string::npos) throw wrong;
  }
  if (endpoint.host.empty()) throw wrong;
  if (!port.empty()) {
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), endpoint.port);
    if (error != std::errc{} || end != port.data() + port.size()) throw wrong;
  }
  return endpoint;
}

}  // namespace coherency
