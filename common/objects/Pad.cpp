#include "common/objects/Pad.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kCorner = 0.035;   // radius
constexpr double kBevel = 0.014;    // how far the softened edge reaches into the thickness
constexpr double kBevelIn = 0.008;  // and into the board's large side
constexpr int kCornerPoints = 3;
constexpr int kPoints = 4 * kCornerPoints;

/// Along the axes in the cycle x, y, z: the first is the one across the board.
Coord3 onAxes(Pad::Thick across, double w, double u, double v) {
  if (across == Pad::Thick::X) return {w, u, v};
  if (across == Pad::Thick::Y) return {v, w, u};
  return {u, v, w};
}

/// A rectangle of these half extents with round corners, smaller by `inset` all around: its edges stay
/// parallel to themselves, so that what joins two of them is plane.
void appendOutline(std::vector<Coord3>& points, Pad::Thick across, double w, double half_u, double half_v,
                   double inset) {
  for (int i = 0; i < kPoints; ++i) {
    const int corner = i / kCornerPoints;
    const double angle = kTurn / 4 * (corner + static_cast<double>(i % kCornerPoints) / (kCornerPoints - 1));
    const double u = (corner == 0 || corner == 3 ? 1.0 : -1.0) * (half_u - kCorner);
    const double v = (corner < 2 ? 1.0 : -1.0) * (half_v - kCorner);
    const double radius = kCorner - inset;
    points.push_back(onAxes(across, w, u + radius * std::cos(angle), v + radius * std::sin(angle)));
  }
}

}  // namespace

void Pad::setSize(const Coord3& size, Thick across) {
  const double w = (across == Thick::X ? size.x : (across == Thick::Y ? size.y : size.z)) / 2;
  const double u = (across == Thick::X ? size.y : (across == Thick::Y ? size.z : size.x)) / 2;
  const double v = (across == Thick::X ? size.z : (across == Thick::Y ? size.x : size.y)) / 2;
  if (!(w > 1.2 * kBevel && u > kCorner && v > kCorner))
    throw std::invalid_argument("Pad: size is too small for its rounded edges");
  std::vector<Coord3> points;
  appendOutline(points, across, -w, u, v, kBevelIn);
  appendOutline(points, across, -w + kBevel, u, v, 0.0);
  appendOutline(points, across, w - kBevel, u, v, 0.0);
  appendOutline(points, across, w, u, v, kBevelIn);
  constexpr std::uint32_t kRing = kPoints;
  std::vector<std::vector<std::uint32_t>> faces(2);
  for (std::uint32_t i = 0; i < kRing; ++i) {
    faces[0].push_back(kRing - 1 - i);
    faces[1].push_back(3 * kRing + i);
    const std::uint32_t next = (i + 1) % kRing;
    for (std::uint32_t ring = 0; ring < 3 * kRing; ring += kRing)
      faces.push_back({ring + i, ring + next, ring + kRing + next, ring + kRing + i});
  }
  setShape(std::move(points), std::move(faces), true);
  setCreaseAngle(kTurn / 7);  // large sides stay flat, all else is smooth
}

}  // namespace coherency
