#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "common/wire/Packets.h"
#include "motion_server/broadcast/Broadcaster.h"

namespace coherency {

/// Certifies that the eyes agree: pairs the frames that a left and a right client drew from the same sample,
/// whichever is reported first, and compares the hash of what they drew. Of several frames of one eye from
/// one sample the first counts. Remembers the newest few thousand samples; memory is bounded whatever is
/// reported.
class StereoAgreement {
 public:
  StereoAgreement();

  /// `eye` other than left and right has no partner and is passed over.
  void add(std::string_view eye, const FrameReport& frame);

  const StereoStatus& status() const { return status_; }

 private:
  static constexpr std::size_t kRemembered = 4096;
  using Frames = std::vector<FrameReport>;  ///< by sequence modulo kRemembered

  void compare(const FrameReport& left, const FrameReport& right);

  std::array<Frames, 2> frames_;  ///< left, right
  StereoStatus status_;
  std::size_t next_skew_ = 0;
};

}  // namespace coherency
