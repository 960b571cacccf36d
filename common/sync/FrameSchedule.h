#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/sync/Clock.h"

namespace coherency {

/// What an eye needed for one frame: the time from the frame's own moment to its arrival there, and what its
/// picture took.
struct FrameNeed {
  std::int64_t ready_ns = 0;
  std::int64_t draw_ns = 0;
  std::int64_t moment_ns = 0;  ///< the frame's own, of session time
};

struct FrameScheduleConfig {
  std::int64_t frame_ns = 16'000'000;  ///< from one frame's number to the next
  std::int64_t least_margin_ns = 2'000'000;
  std::int64_t most_margin_ns = 100'000'000;
};

/// When what is seen. Frame k belongs to the moment k * frame_ns of the session and is seen a margin later:
/// long enough for the network and for drawing, by what the eyes have needed lately, and no longer, as all of
/// it has to be predicted. The server alone decides, and each frame comes with its time, so that no eye can
/// differ. Where an eye draws more slowly than frames follow each other, every second one (third ...) is left
/// out for all.
class FrameSchedule {
 public:
  /// Preconditions: frame_ns > 0, 0 <= least <= most.
  explicit FrameSchedule(const FrameScheduleConfig& config);

  struct Due {
    std::uint64_t number;
    std::int64_t moment_ns;  ///< its own, of session time
    std::int64_t margin_ns;  ///< from there to when it is seen
  };
  /// The newest frame whose moment has come and that was not given out before. Session time never falls.
  std::optional<Due> take(std::int64_t elapsed_ns);

  /// A frame at an eye. Of the last kNeeds, none older than kMemoryNs, the
  /// margin covers 999 of 1000; it grows by a millisecond a frame at most and shrinks by one a second, so
  /// that what is predicted by it does not jump.
  void heard(const FrameNeed& need);

  std::int64_t marginNs() const { return margin_ns_; }
  std::uint64_t stride() const { return stride_; }  ///< 1: every frame is drawn
  std::int64_t frameNs() const { return config_.frame_ns; }

  static constexpr std::size_t kNeeds = 2048;                ///< a quarter of a minute of two eyes
  static constexpr std::int64_t kMemoryNs = 20'000'000'000;  ///< who has gone holds nobody back for longer
  static constexpr std::uint64_t kMostStride = 16;

 private:
  void reconsider();
  std::int64_t quantile(double q, std::int64_t (*of)(const FrameNeed&));
  void fitStride(std::int64_t draw_ns);

  FrameScheduleConfig config_;
  std::vector<FrameNeed> needs_;
  std::vector<std::int64_t> sorted_;
  std::size_t next_ = 0;
  std::int64_t newest_moment_ns_ = 0;
  std::size_t unconsidered_ = 0;
  std::int64_t wanted_margin_ns_;
  std::int64_t margin_ns_;
  std::uint64_t stride_ = 1;
  std::uint64_t last_ = 0;
};

}  // namespace coherency
