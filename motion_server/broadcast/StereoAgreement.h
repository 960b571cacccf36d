#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "common/wire/Messages.h"

namespace coherency {

/// How far the two eyes' pictures were of one moment.
struct StereoStatus {
  std::uint64_t frames_compared = 0;  ///< drawn by both eyes
  std::uint64_t frames_agreeing = 0;  ///< of those, from equal states
  std::uint64_t other_tick = 0;       ///< of those that do not agree: from states of two moments
  std::uint64_t other_state = 0;      ///< or from two states of one moment
  /// Drawn by one eye alone, by what the other says became of it.
  std::uint64_t input_late = 0;
  std::uint64_t drawing_late = 0;
  std::uint64_t mismatch = 0;
  std::uint64_t lost = 0;                     ///< it says nothing: nothing of the frame has come to it
  std::vector<std::int64_t> present_skew_ns;  ///< right minus left, of the newest few thousand compared

  std::uint64_t oneEyed() const { return input_late + drawing_late + mismatch + lost; }
  /// Of all frames that an eye showed while both were there, the part that both showed alike; 1 of none.
  double agreement() const;
};

/// Certifies that the eyes agree: pairs what a left and a right client say of a frame, whichever says it
/// first. What an eye says comes by rising number, so that a number passed over will not be said any more.
/// Remembers the newest few thousand frames; memory is bounded whatever is reported.
class StereoAgreement {
 public:
  StereoAgreement();

  /// `eye` other than left and right has no partner and is passed over. So is a number that does not rise.
  void add(std::string_view eye, const FrameReport& frame);
  /// The eye has gone: what it does not say from here on is not missed.
  void left(std::string_view eye);

  const StereoStatus& status() const { return status_; }

 private:
  static constexpr std::size_t kRemembered = 4096;
  struct Eye {
    std::vector<std::optional<FrameReport>> frames;  ///< by number modulo kRemembered
    std::uint64_t first = 0;                         ///< since it came; 0: it says nothing yet
    std::uint64_t newest = 0;
    const FrameReport* said(std::uint64_t number) const;
    bool passedOver(std::uint64_t number) const;
  };

  void compare(const FrameReport& left, const FrameReport& right);
  void countOneEyed(Fate other);

  std::array<Eye, 2> eyes_;  ///< left, right
  StereoStatus status_;
  std::size_t next_skew_ = 0;
};

}  // namespace coherency
