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
    : illumination_(std::move(illumination)), scene_(scene) {}

LampChoice::Candidate LampChoice::candidate(std::size_t number, const Coord3& place) const {
  const Light& lamp = illumination_.lamps[number];
  const glm::vec3 away((lamp.position - place).glm());
  const float open =
      brightness(colourOf(lamp)) * falloff(glm::dot(away, away), static_cast<float>(lamp.reach));
  // Half is all: of the places about what stands at a wall, or in it as a door does, half are on the wall's
  // other side, where nothing of it is to be lit from this one.
  const float in_sight = open > 0.0F ? std::min(1.0F, 2.0F * scene_.inSight(number, place)) : 0.0F;
  return {number, in_sight, open * in_sight};
}

ChosenLamps LampChoice::at(const Coord3& place) const {
  ChosenLamps chosen;
  const auto leaveOut = [&](const Candidate& candidate, float share) {
    if (!(candidate.strength > 0.0F)) return;  // none, perhaps
    const glm::vec3 colour = colourOf(illumination_.lamps[candidate.lamp]);
    chosen.others += colour * (candidate.strength * share / brightness(colour));
  };
  // The strongest first, equal ones in the lamps' order; one more than are chosen.
  std::array<Candidate, kChosenLamps + 1> strongest{};
  for (std::size_t i = 0; i < illumination_.lamps.size(); ++i) {
    Candidate weaker = candidate(i, place);
    for (Candidate& stronger : strongest)
      if (weaker.strength > stronger.strength) std::swap(stronger, weaker);
    leaveOut(weaker, 1.0F);
  }
  const Candidate& fifth = strongest.back();
  leaveOut(fifth, 1.0F);
  for (std::size_t i = 0; i < kChosenLamps && strongest[i].strength > 0.0F; ++i) {
    const Light& lamp = illumination_.lamps[strongest[i].lamp];
    const float weight = (strongest[i].strength - fifth.strength) / strongest[i].strength;
    leaveOut(strongest[i], 1.0F - weight);
    chosen.lamps[i] = {lamp.position, weight * strongest[i].in_sight * colourOf(lamp),
                       static_cast<float>(lamp.reach)};
  }
  return chosen;
}

}  // namespace coherency
