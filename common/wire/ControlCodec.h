#pragma once

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "common/wire/Messages.h"
#include "common/wire/Reject.h"

namespace coherency {

using ControlMessage = std::variant<Hello, Join, SessionConfig, Keyframe, KeyframeRequest, ClientReport,
                                    ModeRequest, Tunnelled, Goodbye>;
using DecodedControl = std::variant<Reject, ControlMessage>;

/// Appends the message, not sealed and without its length. A SessionConfig travels as Welcome. Precondition:
/// isValid() of what is given.
void encodeControl(const ControlMessage& message, std::vector<std::byte>& out);

/// One message, opened; any bytes. What comes out is valid. A Hello of another major version comes out with
/// nothing but its number.
DecodedControl decodeControl(std::span<const std::byte> message);

}  // namespace coherency
