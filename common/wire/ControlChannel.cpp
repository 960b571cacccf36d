#include "common/wire/ControlChannel.h"

#include <cassert>

namespace coherency {

ControlChannel::ControlChannel(Side side, const Key& preshared, const Key& secret)
    : side_(side), preshared_(preshared), handshake_(secret) {}

Hello ControlChannel::hello() const {
  return {kWireMajor, kWireMinor, handshake_.publicKey(), preshared_ != kNoKey};
}

bool ControlChannel::agree(const Hello& theirs) {
  assert(!keys_ && !own_hello_.empty() && !their_hello_.empty());
  const bool client = side_ == Side::Client;
  keys_ = handshake_.keys(theirs.public_key, preshared_, client ? own_hello_ : their_hello_,
                          client ? their_hello_ : own_hello_);
  if (!keys_) return false;
  sealer_.emplace(client ? keys_->client_control : keys_->server_control);
  opener_.emplace(client ? keys_->server_control : keys_->client_control);
  return true;
}

const ConnectionKeys& ControlChannel::keys() const {
  assert(keys_);
  return *keys_;
}

std::optional<DecodedControl> ControlChannel::next() {
  const auto message = framing_.next();
  if (!message) return std::nullopt;
  const bool sealed = !message->empty() && message->front() == kSealedMessage;
  return sealed ? open(*message) : readClear(*message);
}

DecodedControl ControlChannel::open(std::span<std::byte> message) {
  if (!opener_) return Reject::Malformed;
  const auto body = opener_->open(message);
  if (!body) return Reject::Forged;
  proven_ = true;
  return decodeControl(*body);
}

DecodedControl ControlChannel::readClear(std::span<const std::byte> message) {
  if (proven_) return Reject::Forged;
  DecodedControl decoded = decodeControl(message);
  const auto* const said = std::get_if<ControlMessage>(&decoded);
  if (said == nullptr || std::holds_alternative<Goodbye>(*said)) return decoded;
  if (!std::holds_alternative<Hello>(*said) || keys_) return Reject::Malformed;
  their_hello_.assign(message.begin(), message.end());
  return decoded;
}

bool ControlChannel::isSealed(const ControlMessage& message) const {
  const bool may_be_clear = side_ == Side::Server && !proven_ && std::holds_alternative<Goodbye>(message);
  return keys_ && !may_be_clear;
}

void ControlChannel::write(const ControlMessage& message, std::vector<std::byte>& out) {
  const std::size_t start = out.size();
  const std::size_t body = start + kControlPrefix;
  const bool sealed = isSealed(message);
  out.resize(body + (sealed ? 1 : 0));
  encodeControl(message, out);
  if (std::holds_alternative<Hello>(message))
    own_hello_.assign(out.begin() + static_cast<std::ptrdiff_t>(body), out.end());
  if (sealed) sealer_->seal(out, body);
  finishControlFrame(out, start);
}

}  // namespace coherency
