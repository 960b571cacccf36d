#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "render_client/compile/CompiledScene.h"

namespace coherency {

/// Lamps that light what moves.
inline constexpr std::size_t kChosenLamps = 4;

struct ChosenLamp {
  Coord3 position;         ///< m, in the world
  glm::vec3 colour{0.0F};  ///< times intensity and weight; zero where no lamp is left to be chosen
  float reach = 1.0F;      ///< m
};

struct ChosenLamps {
  std::array<ChosenLamp, kChosenLamps> lamps;
  glm::vec3 others{0.0F};  ///< irradiance, at the place they were chosen for, of all that was left out
};

/// Chooses, for a place, the lamps that are strongest there, those behind walls less or not at all. Each is
/// weighted by how much stronger it is than the strongest left out, (s_i - s_5) / s_i, so that none appears
/// or vanishes suddenly as the place moves. A function of the place alone: every eye that asks gets the same.
/// Const: any number of threads may ask at once.
class LampChoice {
 public:
  LampChoice(Illumination illumination, const CompiledScene& scene);

  std::size_t lampCount() const { return illumination_.lamps.size(); }

  ChosenLamps at(const Coord3& place) const;

 private:
  struct Candidate {
    std::size_t lamp;
    float in_sight;  ///< share of it
    float strength;  ///< brightness of the irradiance it brings
  };

  Candidate candidate(std::size_t lamp, const Coord3& place) const;

  Illumination illumination_;
  const CompiledScene& scene_;
};

}  // namespace coherency
