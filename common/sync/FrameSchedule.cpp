#include "common/sync/FrameSchedule.h"

#include <algorithm>
#include <cassert>

namespace coherency {
namespace {

constexpr std::size_t kReconsiderAfter = 32;   // needs: a quarter of a second of two eyes
constexpr std::int64_t kGrowthNs = 1'000'000;  // a frame
constexpr std::int64_t kShrinkPerSecondNs = 1'000'000;
constexpr std::int64_t kSlackNs = 500'000;  // for what no eye has met yet
constexpr double kCovered = 0.999;
constexpr double kTypical = 0.9;
constexpr double kFull = 0.95;  // of the time between frames: slower drawing leaves frames out
constexpr double kEasy =
    0.8;  // of the time there would be with one frame fewer left out: faster takes it back

}  // namespace

FrameSchedule::FrameSchedule(const FrameScheduleConfig& config)
    : config_(config),
      wanted_margin_ns_(std::clamp(config.frame_ns, config.least_margin_ns, config.most_margin_ns)),
      margin_ns_(wanted_margin_ns_) {
  assert(config.frame_ns > 0 && config.least_margin_ns >= 0 &&
         config.least_margin_ns <= config.most_margin_ns);
  needs_.reserve(kNeeds);
  sorted_.reserve(kNeeds);
}

std::optional<FrameSchedule::Due> FrameSchedule::take(std::int64_t elapsed_ns) {
  const auto number = static_cast<std::uint64_t>(std::max<std::int64_t>(0, elapsed_ns / config_.frame_ns)) /
                      stride_ * stride_;
  if (number <= last_) return std::nullopt;
  const auto frames = static_cast<std::int64_t>(number - last_);
  last_ = number;
  const std::int64_t shrink =
      kShrinkPerSecondNs * std::min<std::int64_t>(frames * config_.frame_ns, 1'000'000'000) / 1'000'000'000;
  margin_ns_ += std::clamp(wanted_margin_ns_ - margin_ns_, -shrink, kGrowthNs);
  return Due{number, static_cast<std::int64_t>(number) * config_.frame_ns, margin_ns_};
}

void FrameSchedule::heard(const FrameNeed& need) {
  if (needs_.size() < kNeeds)
    needs_.push_back(need);
  else
    needs_[next_] = need;
  next_ = (next_ + 1) % kNeeds;
  newest_moment_ns_ = std::max(newest_moment_ns_, need.moment_ns);
  if (++unconsidered_ >= kReconsiderAfter) reconsider();
}

void FrameSchedule::reconsider() {
  unconsidered_ = 0;
  const std::int64_t need = quantile(kCovered, [](const FrameNeed& n) { return n.ready_ns + n.draw_ns; });
  wanted_margin_ns_ = std::clamp(need + kSlackNs, config_.least_margin_ns, config_.most_margin_ns);
  fitStride(quantile(kTypical, [](const FrameNeed& n) { return n.draw_ns; }));
}

/// Nearest rank, rounded up.
std::int64_t FrameSchedule::quantile(double q, std::int64_t (*of)(const FrameNeed&)) {
  sorted_.clear();
  for (const FrameNeed& need : needs_)
    if (newest_moment_ns_ - need.moment_ns <= kMemoryNs) sorted_.push_back(of(need));
  const auto rank = static_cast<std::size_t>(q * static_cast<double>(sorted_.size()));
  const auto at = sorted_.begin() + static_cast<std::ptrdiff_t>(std::min(rank, sorted_.size() - 1));
  std::nth_element(sorted_.begin(), at, sorted_.end());
  return *at;
}

void FrameSchedule::fitStride(std::int64_t draw_ns) {
  const auto frames = [&](std::uint64_t stride) {
    return static_cast<double>(config_.frame_ns) * static_cast<double>(stride);
  };
  const auto draw = static_cast<double>(draw_ns);
  while (stride_ < kMostStride && draw > kFull * frames(stride_)) ++stride_;
  while (stride_ > 1 && draw < kEasy * frames(stride_ - 1)) --stride_;
}

}  // namespace coherency
