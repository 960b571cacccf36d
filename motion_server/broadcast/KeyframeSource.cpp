#include "motion_server/broadcast/KeyframeSource.h"

namespace coherency {
namespace {

bool hasChanged(const WorldState& a, const WorldState& b) {
  return a.movables != b.movables || a.doors != b.doors || a.task != b.task;
}

}  // namespace

const Keyframe& KeyframeSource::current(const WorldState& state, ServerTime now) {
  const std::lock_guard lock(mutex_);
  if (current_.number == 0) {
    current_ = {1, state};
    made_ = now;
  }
  if (next_) {
    if (all_have_ >= next_->number || now - made_ >= kPatienceNs) {
      current_ = std::move(*next_);
      next_.reset();
    }
  } else if (now - made_ >= kEveryNs && hasChanged(state, current_.world)) {
    next_ = Keyframe{current_.number + 1, state};
    made_ = now;
    all_have_ = 0;  // what was heard before there was this one says nothing of it
  }
  return current_;
}

std::vector<Keyframe> KeyframeSource::needed() const {
  const std::lock_guard lock(mutex_);
  std::vector<Keyframe> keyframes;
  if (current_.number != 0) keyframes.push_back(current_);
  if (next_) keyframes.push_back(*next_);
  return keyframes;
}

std::uint32_t KeyframeSource::newest() const {
  const std::lock_guard lock(mutex_);
  return next_ ? next_->number : current_.number;
}

void KeyframeSource::allHave(std::uint32_t number) {
  const std::lock_guard lock(mutex_);
  all_have_ = number;
}

}  // namespace coherency
