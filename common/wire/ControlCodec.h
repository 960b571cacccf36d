#pragma once

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "common/wire/Envelope.h"
#include "common/wire/Packets.h"

namespace coherency {

using DecodedControl = std::variant<Reject, Hello, SessionConfig, ClientReport, Goodbye, ModeRequest>;

/// The message with its length before it, ready for the stream (ControlFraming.h). A SessionConfig travels as
/// Welcome. Precondition: isValid() of what is given.
std::vector<std::byte> encodeControl(const Hello& hello);
std::vector<std::byte> encodeControl(const SessionConfig& welcome);
std::vector<std::byte> encodeControl(const ClientReport& report);
std::vector<std::byte> encodeControl(const Goodbye& goodbye);
std::vector<std::byte> encodeControl(const ModeRequest& request);

/// One message as ControlFraming gives it out; any bytes. What comes out is valid. A Welcome of another major
/// version is Reject::Version; a Hello of another comes out with nothing but its version.
DecodedControl decodeControl(std::span<const std::byte> message);

}  // namespace coherency
