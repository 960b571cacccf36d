#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace coherency {

/// Largest control message, without its length.
inline constexpr std::size_t kMaxControlMessage = 64 * 1024;
inline constexpr std::size_t kControlPrefix = 4;  ///< the length: uint32, big-endian

/// Cuts a TCP stream, however chopped, into control messages. Holds at most one message and what was fed with
/// its end.
class ControlFraming {
 public:
  void feed(std::span<const std::byte> bytes);
  /// The next whole message, to be opened where it lies, good until the next call of either; nullopt when
  /// more bytes are needed, and for ever after a length beyond kMaxControlMessage.
  std::optional<std::span<std::byte>> next();

  bool oversized() const { return oversized_; }
  /// A stream that ends now was cut off within a message.
  bool midMessage() const { return read_ < buffer_.size(); }

 private:
  std::vector<std::byte> buffer_;
  std::size_t read_ = 0;  ///< of buffer_, what next() has given out
  bool oversized_ = false;
};

/// Precedes the bytes from `start` to the end of `out`, where kControlPrefix bytes were left free, with their
/// length.
void finishControlFrame(std::vector<std::byte>& out, std::size_t start);

}  // namespace coherency
