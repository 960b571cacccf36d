#include "common/wire/SealedStream.h"

#include <cassert>

#include "common/wire/Sodium.h"

namespace coherency {
namespace {

constexpr std::size_t kKind = 1;  // bytes

}  // namespace

StreamSealer::StreamSealer(const Key& key) : key_(key) {
  requireSodium();
}

void StreamSealer::seal(std::vector<std::byte>& message, std::size_t body_start) {
  assert(message.size() >= body_start + kKind);
  message[body_start] = kSealedMessage;
  message.resize(message.size() + kSealTag);
  const auto sealed = std::span(message).subspan(body_start);
  encrypt(key_, nonceOf(0, count_++), sealed.first(kKind),
          sealed.subspan(kKind, sealed.size() - kKind - kSealTag), sealed.last<kSealTag>());
}

StreamOpener::StreamOpener(const Key& key) : key_(key) {
  requireSodium();
}

std::optional<std::span<const std::byte>> StreamOpener::open(std::span<std::byte> message) {
  if (message.size() < kKind + kSealTag || message.front() != kSealedMessage) return std::nullopt;
  const auto body = message.subspan(kKind, message.size() - kKind - kSealTag);
  if (!decrypt(key_, nonceOf(0, count_), message.first(kKind), body, message.last<kSealTag>())) {
    return std::nullopt;
  }
  ++count_;
  return body;
}

}  // namespace coherency
