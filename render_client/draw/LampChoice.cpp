#include "render_client/draw/LampChoice.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace coherency {
namespace {

glm::vec3 colourOf(const Light& lamp) {
  return glm::vec3((lamp.colour * lamp.intensity).glm());
}

}  // namespace

LampChoice::LampChoice(Illumination illumination, const CompiledScene& scene)
    : illumination_(std::move(illumination)), scene_(scene) {
  candidates_.reserve(illumination_.lamps.size());
}

void LampChoice::weigh(const Coord3& place) {
  candidates_.clear();
  for (std::size_t i = 0; i < illumination_.lamps.size(); ++i) {
    const Light& lamp = illumination_.lamps[i];
    const glm::vec3 away((lamp.position - place).glm());
    const float open =
        brightness(colourOf(lamp)) * falloff(glm::dot(away, away), static_cast<float>(lamp.reach));
    const float in_sight = open > 0.0F ? scene_.inSight(i, place) : 0.0F;
    if (in_sight > 0.0F) candidates_.push_back({i, in_sight, open * in_sight});
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.strength != b.strength ? a.strength > b.strength : a.lamp < b.lamp;
  });
}

ChosenLamps LampChoice::at(const Coord3& place) {
  weigh(place);
  const float left_out = candidates_.size() > kChosenLamps ? candidates_[kChosenLamps].strength : 0.0F;
  ChosenLamps chosen;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Candidate& candidate = candidates_[i];
    const Light& lamp = illumination_.lamps[candidate.lamp];
    const float weight = i < kChosenLamps ? (candidate.strength - left_out) / candidate.strength : 0.0F;
    const glm::vec3 hue = colourOf(lamp) / brightness(colourOf(lamp));
    chosen.others += hue * (candidate.strength * (1.0F - weight));
    if (i < kChosenLamps)
      chosen.lamps[i] = {lamp.position, weight * candidate.in_sight * colourOf(lamp),
                         static_cast<float>(lamp.reach)};
  }
  return chosen;
}

}  // namespace coherency
