#pragma once

#include <cstdint>
#include <optional>

#include "common/sync/Clock.h"
#include "common/sync/DurationHistogram.h"
#include "render_client/receive/ServerLink.h"

namespace coherency {

/// Which frame is drawn next, when it is shown, and what the server is told of both. All eyes of a session
/// show the same frames at the same time, as each frame says itself when it is to be seen.
class FramePacing {
 public:
  /// Both outlive this.
  FramePacing(ServerLink& link, const Clock& clock) : link_(link), clock_(clock) {}

  /// Begins with a session: all of its frames are drawn, or one of two (three ...) where so many a second are
  /// more than `fps`; 0: no limit.
  void begin(const SessionConfig& session, double fps);

  /// The session time of a frame's own moment, and the first frame whose moment is not before a time.
  double momentS(std::uint64_t number) const;
  std::uint64_t frameAt(double session_s) const;
  double secondsBetween() const { return momentS(stride_); }
  /// Frames there would have been from the newest shown to this one.
  std::uint64_t framesSince(std::uint64_t number) const;

  /// The next frame to draw; none where none comes for a while.
  std::optional<ReceivedFrame> await() const;
  /// The first frame from this number on, however long ago it came. None until some frames later, when what
  /// came in another order has come.
  std::optional<ReceivedFrame> firstFrom(std::uint64_t number) const;

  /// About to draw it: those that came before it and are not drawn are reported.
  void choose(const ReceivedFrame& frame);
  /// It could not be drawn, as its state does not have its hash: keyframes are asked for.
  void mismatched(const ReceivedFrame& frame);
  /// Its picture is complete: returns when it is to be handed over.
  void awaitPhotons(const ReceivedFrame& frame) const;
  /// It was handed over just now. `tick` and `hash`: of the state drawn.
  void shown(const ReceivedFrame& frame, std::uint64_t tick, std::uint64_t hash, std::int64_t draw_ns);

  std::uint64_t newestShown() const { return shown_; }
  const DurationHistogram& drawing() const { return drawing_; }             ///< of pictures
  const DurationHistogram& motionToPresent() const { return to_present_; }  ///< from sampling on
  const DurationHistogram& lateness() const { return lateness_; }           ///< after the frame's time

 private:
  ServerTime earliestSeen() const;
  void report(const FrameReport& frame);
  std::optional<ReceivedFrame> next() const;
  ClientTime now() const { return {clock_.nowNs()}; }

  ServerLink& link_;
  const Clock& clock_;
  std::uint64_t session_id_ = 0;
  std::int64_t frame_ns_ = 0;
  std::uint64_t stride_ = 1;  ///< of so many frames one is drawn
  std::uint64_t shown_ = 0;
  ClientTime shown_at_;
  ClientTime first_shown_at_;  ///< of this session
  std::int64_t typical_draw_ns_ = 0;
  ClientTime asked_for_keyframes_;
  DurationHistogram drawing_;
  DurationHistogram to_present_;
  DurationHistogram lateness_;
};

}  // namespace coherency
