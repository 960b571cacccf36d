#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace coherency {

struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
};

/// HOST:PORT, with brackets about an IPv6 address.
std::string describe(const Endpoint& endpoint);

/// A server to connect to: HOST, HOST:PORT, [IPV6] or [IPV6]:PORT; the port is `fallback` where none is
/// given. Throws ConfigError.
Endpoint parseEndpoint(const std::string& text, std::uint16_t fallback);

/// The same for an address to listen on, of which `host` is the numeric form.
Endpoint parseListenEndpoint(const std::string& text, std::uint16_t fallback);

/// An address to listen on in its shortest numeric form; localhost is 127.0.0.1. nullopt for anything else: a
/// server asks no resolver where it is.
std::optional<std::string> listenAddress(const std::string& text);
bool isLoopback(const std::string& numeric_address);
/// 224.0.0.0/4, numeric.
bool isMulticast(const std::string& address);

}  // namespace coherency
