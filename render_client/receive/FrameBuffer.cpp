#include "render_client/receive/FrameBuffer.h"

#include <algorithm>

namespace coherency {

bool FrameBuffer::add(const ReceivedFrame& frame) {
  const std::uint64_t number = frame.state.number;
  if (number > kMostNumber || number + kRemembered <= newest_) return false;
  auto& place = frames_[number % kRemembered];
  if (place && place->state.number >= number) return false;
  place = frame;
  newest_ = std::max(newest_, number);
  for (auto& [from, first] : kept_)
    if (number >= from && (!first || number < first->state.number)) first = frame;
  return true;
}

void FrameBuffer::clear() {
  for (auto& frame : frames_) frame.reset();
  for (auto& [from, first] : kept_) first.reset();
  newest_ = 0;
}

const ReceivedFrame* FrameBuffer::find(std::uint64_t number) const {
  const auto& place = frames_[number % kRemembered];
  return place && place->state.number == number ? &*place : nullptr;
}

/// The first of the numbers [group * stride, (group + 1) * stride) that is here.
const ReceivedFrame* FrameBuffer::firstOf(std::uint64_t group, std::uint64_t stride) const {
  for (std::uint64_t n = group * stride; n < (group + 1) * stride; ++n)
    if (const ReceivedFrame* const frame = find(n)) return frame;
  return nullptr;
}

std::optional<ReceivedFrame> FrameBuffer::next(std::uint64_t after, std::uint64_t stride, ServerTime earliest,
                                               std::int64_t draw_ns) const {
  const ReceivedFrame* late = nullptr;
  for (std::uint64_t group = std::max(after, oldest()) / stride + 1; group <= newest_ / stride; ++group) {
    const ReceivedFrame* const frame = firstOf(group, stride);
    if (frame == nullptr) continue;
    if (frame->state.photons() >= earliest) {
      const bool time_for_both = late != nullptr && frame->state.photons() - earliest >= draw_ns;
      return time_for_both ? *late : *frame;
    }
    late = frame;
  }
  return late == nullptr ? std::nullopt : std::optional(*late);
}

std::vector<ReceivedFrame> FrameBuffer::between(std::uint64_t after, std::uint64_t before,
                                                std::uint64_t stride) const {
  std::vector<ReceivedFrame> frames;
  const std::uint64_t end = std::min(before / stride, newest_ / stride + 1);
  for (std::uint64_t group = std::max(after, oldest()) / stride + 1; group < end; ++group)
    if (const ReceivedFrame* const frame = firstOf(group, stride)) frames.push_back(*frame);
  return frames;
}

void FrameBuffer::keepFirstFrom(const std::vector<std::uint64_t>& numbers) {
  std::map<std::uint64_t, std::optional<ReceivedFrame>> kept;
  for (const std::uint64_t number : numbers) {
    const auto before = kept_.find(number);
    kept[number] = before == kept_.end() ? std::nullopt : before->second;
  }
  kept_ = std::move(kept);
}

std::optional<ReceivedFrame> FrameBuffer::firstFrom(std::uint64_t number) const {
  const auto kept = kept_.find(number);
  return kept == kept_.end() ? std::nullopt : kept->second;
}

}  // namespace coherency
