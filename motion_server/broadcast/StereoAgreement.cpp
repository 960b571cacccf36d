#include "motion_server/broadcast/StereoAgreement.h"

namespace coherency {

StereoAgreement::StereoAgreement() : frames_{Frames(kRemembered), Frames(kRemembered)} {}

void StereoAgreement::add(std::string_view eye, const FrameReport& frame) {
  if (eye != "left" && eye != "right") return;
  const std::size_t side = eye == "left" ? 0 : 1;
  const std::size_t place = frame.sequence % kRemembered;
  FrameReport& own = frames_[side][place];
  if (own.sequence >= frame.sequence) return;
  own = frame;
  const FrameReport& other = frames_[1 - side][place];
  if (other.sequence != frame.sequence) return;
  if (side == 0) {
    compare(own, other);
  } else {
    compare(other, own);
  }
}

void StereoAgreement::compare(const FrameReport& left, const FrameReport& right) {
  ++status_.frames_compared;
  if (left.hash == right.hash) ++status_.frames_agreeing;
  const std::int64_t skew = right.presented_server_ns - left.presented_server_ns;
  if (status_.present_skew_ns.size() < kRemembered) {
    status_.present_skew_ns.push_back(skew);
  } else {
    status_.present_skew_ns[next_skew_] = skew;
    next_skew_ = (next_skew_ + 1) % kRemembered;
  }
}

}  // namespace coherency
