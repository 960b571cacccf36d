#include "common/wire/KeyframeStore.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/world/StateFields.h"

namespace coherency {
namespace {

using Fields = std::vector<std::pair<std::string, std::uint64_t>>;

Fields fieldsOf(const WorldState& state) {
  Fields fields;
  forEachField(state, [&](const char* name, const auto& field) {
    fields.emplace_back(name, static_cast<std::uint64_t>(field));
  });
  return fields;
}

}  // namespace

std::optional<std::string> firstDifference(const WorldState& a, const WorldState& b) {
  const Fields of_a = fieldsOf(a);
  const Fields of_b = fieldsOf(b);
  const auto [in_a, in_b] = std::mismatch(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
  if (in_a != of_a.end()) return in_a->first;
  if (in_b != of_b.end()) return in_b->first;
  return std::nullopt;
}

std::optional<std::string> KeyframeStore::add(const Keyframe& keyframe) {
  for (Keyframe& kept : kept_) {
    if (kept.number != keyframe.number) continue;
    auto difference = firstDifference(kept.world, keyframe.world);
    kept = keyframe;
    return difference;
  }
  Keyframe& oldest = kept_[0].number <= kept_[1].number ? kept_[0] : kept_[1];
  if (keyframe.number > oldest.number) oldest = keyframe;
  return std::nullopt;
}

const WorldState* KeyframeStore::find(std::uint32_t number) const {
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Keyframe& kept) { return number != 0 && kept.number == number; });
  return found == kept_.end() ? nullptr : &found->world;
}

std::uint32_t KeyframeStore::newest() const {
  return std::max(kept_[0].number, kept_[1].number);
}

}  // namespace coherency
