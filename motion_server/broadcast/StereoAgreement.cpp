#include "motion_server/broadcast/StereoAgreement.h"

#include <algorithm>

namespace coherency {
namespace {

std::optional<std::size_t> sideOf(std::string_view eye) {
  if (eye == "left") return 0;
  if (eye == "right") return 1;
  return std::nullopt;
}

}  // namespace

double StereoStatus::agreement() const {
  const std::uint64_t shown = frames_compared + oneEyed();
  return shown == 0 ? 1.0 : static_cast<double>(frames_agreeing) / static_cast<double>(shown);
}

StereoAgreement::StereoAgreement() {
  for (Eye& eye : eyes_) eye.frames.resize(kRemembered);
}

const FrameReport* StereoAgreement::Eye::said(std::uint64_t number) const {
  const auto& frame = frames[number % kRemembered];
  return frame && frame->number == number ? &*frame : nullptr;
}

bool StereoAgreement::Eye::passedOver(std::uint64_t number) const {
  const bool remembered = number >= first && number < newest && newest - number < kRemembered;
  return first != 0 && remembered && said(number) == nullptr;
}

void StereoAgreement::add(std::string_view eye, const FrameReport& frame) {
  const auto side = sideOf(eye);
  if (!side || frame.number <= eyes_[*side].newest) return;
  Eye& own = eyes_[*side];
  const Eye& other = eyes_[1 - *side];
  // What the other eye showed and this one will not speak of any more.
  if (own.first != 0) {
    const std::uint64_t oldest = frame.number > kRemembered ? frame.number - kRemembered : 0;
    const std::uint64_t end =
        std::min(frame.number, other.newest + 1);  // beyond it the other has said nothing
    for (std::uint64_t n = std::max(own.newest + 1, oldest); n < end; ++n) {
      const FrameReport* const theirs = other.said(n);
      if (theirs != nullptr && theirs->fate == Fate::Drawn) ++status_.lost;
    }
  } else {
    own.first = frame.number;
  }
  own.newest = frame.number;
  own.frames[frame.number % kRemembered] = frame;
  if (const FrameReport* const theirs = other.said(frame.number)) {
    *side == 0 ? compare(frame, *theirs) : compare(*theirs, frame);
  } else if (frame.fate == Fate::Drawn && other.passedOver(frame.number)) {
    ++status_.lost;
  }
}

void StereoAgreement::left(std::string_view eye) {
  if (const auto side = sideOf(eye)) {
    eyes_[*side].first = eyes_[*side].newest = 0;
    std::fill(eyes_[*side].frames.begin(), eyes_[*side].frames.end(), std::nullopt);
  }
}

void StereoAgreement::compare(const FrameReport& left, const FrameReport& right) {
  const bool both = left.fate == Fate::Drawn && right.fate == Fate::Drawn;
  if (!both) {
    if (left.fate == Fate::Drawn) countOneEyed(right.fate);
    if (right.fate == Fate::Drawn) countOneEyed(left.fate);
    return;
  }
  ++status_.frames_compared;
  if (left.tick != right.tick)
    ++status_.other_tick;
  else if (left.hash != right.hash)
    ++status_.other_state;
  else
    ++status_.frames_agreeing;
  const std::int64_t skew = right.presented_server_ns - left.presented_server_ns;
  if (status_.present_skew_ns.size() < kRemembered) {
    status_.present_skew_ns.push_back(skew);
  } else {
    status_.present_skew_ns[next_skew_] = skew;
    next_skew_ = (next_skew_ + 1) % kRemembered;
  }
}

void StereoAgreement::countOneEyed(Fate other) {
  switch (other) {
    case Fate::Drawn:
      break;
    case Fate::InputLate:
      ++status_.input_late;
      break;
    case Fate::DrawingLate:
      ++status_.drawing_late;
      break;
    case Fate::Mismatch:
      ++status_.mismatch;
      break;
  }
}

}  // namespace coherency
