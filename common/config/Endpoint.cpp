#include "common/config/Endpoint.h"

#include <array>
#include <charconv>

#include <arpa/inet.h>
#include <fmt/format.h>

#include "common/config/ConfigError.h"

namespace coherency {

std::string describe(const Endpoint& endpoint) {
  const bool ipv6 = endpoint.host.find(':') != std::string::npos;
  return fmt::format("{}{}{}:{}", ipv6 ? "[" : "", endpoint.host, ipv6 ? "]" : "", endpoint.port);
}

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
  // A number alone is a port whose host was forgotten; resolvers would take it for an address.
  const bool number = endpoint.host.find_first_not_of("0123456789") == std::string::npos;
  if (number) throw wrong;
  if (!port.empty()) {
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), endpoint.port);
    if (error != std::errc{} || end != port.data() + port.size()) throw wrong;
  }
  return endpoint;
}

Endpoint parseListenEndpoint(const std::string& text, std::uint16_t fallback) {
  const ConfigError wrong(
      fmt::format("\"{}\" is no address of this machine to listen on; right would be 127.0.0.1:{}, [::1]:{} "
                  "or, for all of "
                  "this machine's, 0.0.0.0:{}",
                  text, fallback, fallback, fallback));
  try {
    Endpoint endpoint = parseEndpoint(text, fallback);
    const auto address = listenAddress(endpoint.host);
    if (!address) throw wrong;
    endpoint.host = *address;
    return endpoint;
  } catch (const ConfigError&) {
    throw wrong;
  }
}

std::optional<std::string> listenAddress(const std::string& text) {
  if (text == "localhost") return "127.0.0.1";
  const std::size_t percent = text.find('%');  // of IPv6: after it comes the interface
  const std::string bare = text.substr(0, percent);
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  std::array<char, INET6_ADDRSTRLEN> shortest{};
  for (const int family : {AF_INET, AF_INET6}) {
    if (::inet_pton(family, bare.c_str(), bytes.data()) != 1) continue;
    if (percent != std::string::npos && family == AF_INET) continue;
    ::inet_ntop(family, bytes.data(), shortest.data(), shortest.size());
    return std::string(shortest.data()) + (percent == std::string::npos ? "" : text.substr(percent));
  }
  return std::nullopt;
}

bool isLoopback(const std::string& numeric_address) {
  return numeric_address == "::1" || numeric_address.starts_with("127.");
}

bool isMulticast(const std::string& address) {
  in_addr bytes{};
  return ::inet_pton(AF_INET, address.c_str(), &bytes) == 1 && IN_MULTICAST(ntohl(bytes.s_addr));
}

}  // namespace coherency
