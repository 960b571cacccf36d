#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// Fixed sample points, the same bits everywhere, so that both eyes compute the same light.

namespace coherency {

/// Points spread evenly over the unit disc, the middle first, however many of the first one takes (Roberts'
/// R2 sequence, 2018).
std::vector<glm::vec2> discPoints(std::size_t count);

/// Directions above the plane z = 0, as dense as their cosine to z (Malley's method), so that the mean over
/// them of what they bring is the irradiance; the first of them alone are, too.
std::vector<glm::vec3> cosineDirections(std::size_t count);

/// A right-handed frame whose z axis is the unit vector `n` (Duff et al., Building an Orthonormal Basis,
/// Revisited, 2017).
glm::mat3 frameAbout(const glm::vec3& n);

}  // namespace coherency
