#include "common/wire/ControlFraming.h"

#include <cassert>
#include <cstdint>

namespace coherency {

void ControlFraming::feed(std::span<const std::byte> bytes) {
  if (oversized_) return;
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(read_));
  read_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<std::span<std::byte>> ControlFraming::next() {
  const auto unread = std::span(buffer_).subspan(read_);
  if (oversized_ || unread.size() < kControlPrefix) return std::nullopt;
  std::uint32_t length = 0;
  for (const std::byte b : unread.first(kControlPrefix))
    length = length << 8 | std::to_integer<std::uint32_t>(b);
  if (length > kMaxControlMessage) {
    oversized_ = true;
    buffer_.clear();
    read_ = 0;
    return std::nullopt;
  }
  if (unread.size() - kControlPrefix < length) return std::nullopt;
  read_ += kControlPrefix + length;
  return unread.subspan(kControlPrefix, length);
}

void finishControlFrame(std::vector<std::byte>& out, std::size_t start) {
  assert(out.size() >= start + kControlPrefix);
  const std::size_t length = out.size() - start - kControlPrefix;
  assert(length <= kMaxControlMessage);
  for (std::size_t i = 0; i < kControlPrefix; ++i) {
    out[start + i] = static_cast<std::byte>(length >> (8 * (kControlPrefix - 1 - i)));
  }
}

}  // namespace coherency
