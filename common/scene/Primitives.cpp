#include "common/scene/Primitives.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "common/math/FixedPoint.h"

namespace coherency {
namespace {

using Face = std::vector<std::uint32_t>;

constexpr double kHalfTurn = kTurn / 2.0;
constexpr int kMaxSides = 1024;

void checkSize(double size, bool zero_is_allowed, const char* shape, const char* which) {
  if (std::isfinite(size) && (size > 0.0 || (zero_is_allowed && size == 0.0))) return;
  std::ostringstream text;
  text << shape << ": " << which << " is " << size << " m; it must be finite and "
       << (zero_is_allowed ? "not negative" : "above zero");
  throw std::invalid_argument(text.str());
}

void checkSides(int sides, int least, const char* shape) {
  if (sides >= least && sides <= kMaxSides) return;
  throw std::invalid_argument(std::string(shape) + ": " + std::to_string(sides) + " sides; must be " +
                              std::to_string(least) + " to " + std::to_string(kMaxSides));
}

/// Point `i` of `sides` on a circle about y; they run counter-clockwise seen from +y, from +z towards +x.
Coord3 onCircle(double radius, double y, int i, int sides) {
  const double angle = kTurn * i / sides;
  return {radius * std::sin(angle), y, radius * std::cos(angle)};
}

/// Appends a ring of vertices, or a single one where the radius is zero; returns the indices around it.
Face addRing(std::vector<Coord3>& vertices, double radius, double y, int sides) {
  Face ring(static_cast<std::size_t>(sides), static_cast<std::uint32_t>(vertices.size()));
  if (radius == 0.0) {
    vertices.push_back({0.0, y, 0.0});
    return ring;
  }
  for (int i = 0; i < sides; ++i) {
    ring[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(onCircle(radius, y, i, sides));
  }
  return ring;
}

/// The faces between two rings, `low` below `high`; triangles where one of them is a single vertex.
void addBand(std::vector<Face>& faces, const Face& low, const Face& high) {
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t next = (i + 1) % low.size();
    Face face{low[i], low[next], high[next], high[i]};
    face.erase(std::unique(face.begin(), face.end()), face.end());
    if (face.front() == face.back()) face.pop_back();
    faces.push_back(std::move(face));
  }
}

template <class T>
std::vector<T> everyOther(const std::vector<T>& all) {
  std::vector<T> some;
  for (std::size_t i = 0; i < all.size(); i += 2) some.push_back(all[i]);
  return some;
}

/// Half as many sides, for the next coarser level; 0: there is none. `among`: sides come in multiples of it.
int halfOf(int sides, int among) {
  constexpr int kFewest = 6;
  return sides % (2 * among) == 0 && sides / 2 >= kFewest ? sides / 2 : 0;
}

/// How far a regular polygon lies from the circle about it, of the circle's radius.
double sagitta(int sides) {
  const double sine = std::sin(0.5 * kHalfTurn / sides);
  return 2.0 * sine * sine;
}

std::vector<Face> frustumFaces(const Face& bottom, const Face& top) {
  const auto isPoint = [](const Face& ring) { return ring.front() == ring.back(); };
  std::vector<Face> faces;
  addBand(faces, bottom, top);
  if (!isPoint(top)) faces.push_back(top);
  if (!isPoint(bottom)) faces.emplace_back(bottom.rbegin(), bottom.rend());
  return faces;
}

/// A face's point on the unit sphere stands at least cos(half a side's angle) from the middle for either
/// direction, and where the sphere is stretched, so is the gap, no more than along the longest axis.
double ellipsoidError(const Coord3& semi_axes, int sides) {
  const double sine = std::sin(kHalfTurn / sides);
  return std::max({semi_axes.x, semi_axes.y, semi_axes.z}) * sine * sine;
}

std::vector<Face> facesBetween(const std::vector<Face>& rings) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) addBand(faces, rings[i], rings[i + 1]);
  return faces;
}

/// Crease angle that keeps the caps of a frustum sharp and its side smooth, where the two can be told apart;
/// otherwise (few sides) zero, which keeps every edge sharp.
double frustumCrease(double radius_bottom, double radius_top, double height, int sides) {
  const double slope = std::atan2(std::abs(radius_bottom - radius_top), height);
  const double between_sides = 2.0 * std::asin(std::cos(slope) * std::sin(kHalfTurn / sides));
  const double side_to_cap = kHalfTurn / 2.0 - slope;
  const bool distinct = between_sides < 0.95 * side_to_cap;
  return distinct ? 0.5 * (between_sides + side_to_cap) : 0.0;
}

}  // namespace

Box::Box(const Coord3& size, std::string name) : Polyhedron(std::move(name)) {
  setSize(size);
}

void Box::setSize(const Coord3& size) {
  checkSize(size.x, false, "Box", "size x");
  checkSize(size.y, false, "Box", "size y");
  checkSize(size.z, false, "Box", "size z");
  std::vector<Coord3> vertices;  // bit 0 of the index: +x, bit 1: +y, bit 2: +z
  vertices.reserve(8);
  for (int i = 0; i < 8; ++i)
    vertices.push_back(
        {(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y, (i & 4 ? 0.5 : -0.5) * size.z});
  setShape(std::move(vertices),
           {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}});
}

Cylinder::Cylinder(double radius, double height, int sides, std::string name) : Polyhedron(std::move(name)) {
  setSize(radius, height, sides);
}

void Cylinder::setSize(double radius, double height, int sides) {
  checkSize(radius, false, "Cylinder", "radius");
  setTapered(radius, radius, height, sides);
}

void Cylinder::setTapered(double radius_bottom, double radius_top, double height, int sides) {
  checkSize(radius_bottom, true, "Cylinder", "bottom radius");
  checkSize(radius_top, true, "Cylinder", "top radius");
  checkSize(std::max(radius_bottom, radius_top), false, "Cylinder", "larger radius");
  checkSize(height, false, "Cylinder", "height");
  checkSides(sides, 3, "Cylinder");
  std::vector<Coord3> vertices;
  Face bottom = addRing(vertices, radius_bottom, -0.5 * height, sides);
  Face top = addRing(vertices, radius_top, 0.5 * height, sides);
  std::vector<Face> faces = frustumFaces(bottom, top);
  std::vector<DetailLevel> coarser;
  for (int fewer = halfOf(sides, 1); fewer > 0; fewer = halfOf(fewer, 1)) {
    bottom = everyOther(bottom);
    top = everyOther(top);
    coarser.push_back({frustumFaces(bottom, top), std::max(radius_bottom, radius_top) * sagitta(fewer)});
  }
  setShape(std::move(vertices), std::move(faces), true, std::move(coarser));
  setCreaseAngle(frustumCrease(radius_bottom, radius_top, height, sides));
}

Ellipsoid::Ellipsoid(const Coord3& semi_axes, int sides, std::string name) : Polyhedron(std::move(name)) {
  setSize(semi_axes, sides);
}

void Ellipsoid::setSize(const Coord3& semi_axes, int sides) {
  checkSize(semi_axes.x, false, "Ellipsoid", "semi-axis x");
  checkSize(semi_axes.y, false, "Ellipsoid", "semi-axis y");
  checkSize(semi_axes.z, false, "Ellipsoid", "semi-axis z");
  checkSides(sides, 4, "Ellipsoid");
  if (sides % 2 != 0)
    throw std::invalid_argument("Ellipsoid: " + std::to_string(sides) + " sides; the number must be even");
  std::vector<Coord3> vertices;
  const int bands = sides / 2;
  std::vector<Face> rings{addRing(vertices, 0.0, -1.0, sides)};
  for (int band = 1; band <= bands; ++band) {
    const double latitude = kHalfTurn * band / bands - kHalfTurn / 2.0;
    const bool pole = band == bands;
    rings.push_back(
        addRing(vertices, pole ? 0.0 : std::cos(latitude), pole ? 1.0 : std::sin(latitude), sides));
  }
  for (Coord3& v : vertices) v = {v.x * semi_axes.x, v.y * semi_axes.y, v.z * semi_axes.z};
  std::vector<Face> faces = facesBetween(rings);
  std::vector<DetailLevel> coarser;
  for (int fewer = halfOf(sides, 2); fewer > 0; fewer = halfOf(fewer, 2)) {
    rings = everyOther(rings);
    for (Face& ring : rings) ring = everyOther(ring);
    coarser.push_back({facesBetween(rings), ellipsoidError(semi_axes, fewer)});
  }
  setShape(std::move(vertices), std::move(faces), true, std::move(coarser));
  setCreaseAngle(kHalfTurn);  // smooth all over
}

Rectangle::Rectangle(double width, double height, std::string name) : Polygon(std::move(name)) {
  setSize(width, height);
}

void Rectangle::setSize(double width, double height) {
  checkSize(width, false, "Rectangle", "width");
  checkSize(height, false, "Rectangle", "height");
  const double x = 0.5 * width;
  const double y = 0.5 * height;
  setShape({{-x, -y, 0.0}, {x, -y, 0.0}, {x, y, 0.0}, {-x, y, 0.0}});
}

}  // namespace coherency
