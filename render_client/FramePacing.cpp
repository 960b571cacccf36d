#include "render_client/FramePacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/wire/Validity.h"

namespace coherency {
namespace {

constexpr std::int64_t kPatienceNs = 200'000'000;  // and a frame: without motion the last one is shown again
constexpr std::int64_t kMostWaitNs = 250'000'000;  // for a frame's time, whatever the clocks say
constexpr std::int64_t kAskAgainNs = 200'000'000;  // for keyframes
constexpr std::int64_t kDrawsAveraged = 8;
constexpr double kAbout = 0.1;  // of a frame: a limit of 60 a second does not halve 62.5

}  // namespace

void FramePacing::begin(const SessionConfig& session, double fps) {
  session_id_ = session.session_id;
  frame_ns_ = session.frame_ns;
  const double wanted = fps > 0.0 ? 1e9 / static_cast<double>(frame_ns_) / fps : 1.0;
  stride_ = static_cast<std::uint64_t>(std::max(1.0, std::ceil(wanted - kAbout)));
  shown_ = 0;
}

double FramePacing::momentS(std::uint64_t number) const {
  return static_cast<double>(number) * static_cast<double>(frame_ns_) * 1e-9;
}

std::uint64_t FramePacing::frameAt(double session_s) const {
  return static_cast<std::uint64_t>(std::ceil(session_s / secondsBetween() - 1e-9)) * stride_;
}

std::uint64_t FramePacing::framesSince(std::uint64_t number) const {
  return number > shown_ && shown_ > 0 ? (number - shown_) / stride_ : 1;
}

std::optional<ReceivedFrame> FramePacing::firstFrom(std::uint64_t number) const {
  const auto first = link_.firstFrom(number);
  if (first && first->session_id != session_id_) return std::nullopt;
  const bool none_before = first && first->state.number == number;
  return none_before || link_.newestFrame() >= number + kMaxFrames ? first : std::nullopt;
}

std::optional<ReceivedFrame> FramePacing::await() const {
  if (auto frame = next()) return frame;
  link_.waitForFrame((shown_ / stride_ + 1) * stride_,
                     static_cast<std::int64_t>(stride_) * frame_ns_ + kPatienceNs);
  return next();
}

std::optional<ReceivedFrame> FramePacing::next() const {
  const auto frame = link_.nextFrame(shown_, stride_, earliestSeen(), typical_draw_ns_);
  return frame && frame->session_id == session_id_ ? frame : std::nullopt;
}

/// When a picture that is begun now can be seen; while the clocks are unknown only the newest frame will do.
ServerTime FramePacing::earliestSeen() const {
  const auto done = link_.toServer(now() + typical_draw_ns_);
  return done ? *done : ServerTime{std::numeric_limits<std::int64_t>::max()};
}

void FramePacing::choose(const ReceivedFrame& frame) {
  if (shown_ == 0) return;
  for (const ReceivedFrame& other : link_.framesBetween(shown_, frame.state.number, stride_)) {
    const auto arrived = link_.toServer(other.arrived);
    if (!arrived || other.arrived <= first_shown_at_) continue;  // the first picture takes what no other does
    // What came while the picture before it was being made would have been in time after a faster one.
    const bool was_busy = other.arrived <= shown_at_;
    report({.number = other.state.number,
            .fate = was_busy ? Fate::DrawingLate : Fate::InputLate,
            .arrived_server_ns = arrived->ns,
            .draw_ns = typical_draw_ns_});
  }
}

/// What was shown of a session that is over is nothing to the next one's server.
void FramePacing::report(const FrameReport& frame) {
  if (link_.sessionId() == session_id_) link_.reportFrame(frame);
}

void FramePacing::mismatched(const ReceivedFrame& frame) {
  if (now() - asked_for_keyframes_ >= kAskAgainNs) {
    link_.requestKeyframe();
    asked_for_keyframes_ = now();
  }
  if (frame.state.number <= shown_) return;
  report({.number = frame.state.number, .fate = Fate::Mismatch});
  shown_ = frame.state.number;
}

void FramePacing::awaitPhotons(const ReceivedFrame& frame) const {
  if (const auto at = link_.toClient(frame.state.photons()))
    clock_.sleepUntil(std::min(*at, now() + kMostWaitNs).ns);
}

void FramePacing::shown(const ReceivedFrame& frame, std::uint64_t tick, std::uint64_t hash,
                        std::int64_t draw_ns) {
  drawing_.add(draw_ns);
  shown_at_ = now();
  const auto seen = link_.toServer(shown_at_);
  const auto arrived = link_.toServer(frame.arrived);
  if (!seen || !arrived || frame.state.number <= shown_) return;
  to_present_.add(*seen - frame.sampled);
  lateness_.add(*seen - frame.state.photons());
  if (shown_ == 0) {
    first_shown_at_ = shown_at_;
  } else {
    typical_draw_ns_ += (draw_ns - typical_draw_ns_) / (typical_draw_ns_ == 0 ? 1 : kDrawsAveraged);
    report({frame.state.number, Fate::Drawn, tick, hash, seen->ns, arrived->ns, draw_ns});
  }
  shown_ = frame.state.number;
}

}  // namespace coherency
