#include "common/body/Machined.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

using Face = std::vector<std::uint32_t>;

constexpr int kRound = 8;          // sides from which on a body of revolution is shaded round
constexpr double kRoundBy = 0.80;  // rad: more than eight sides meet at, less than any of their ends

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("machined part: " + what);
}

bool closed(Ends ends, Ends which) {
  return ends == which || ends == Ends::Both;
}

/// Vertices ring by ring and the faces between them; all rings have as many corners.
struct Stack {
  std::vector<Coord3> vertices;
  std::vector<Face> faces;

  void add(const std::vector<Coord3>& ring) { vertices.insert(vertices.end(), ring.begin(), ring.end()); }

  void close(std::uint32_t sides, Ends ends) {
    const auto rings = static_cast<std::uint32_t>(vertices.size()) / sides;
    for (std::uint32_t r = 0; r + 1 < rings; ++r)
      for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t here = r * sides + k;
        const std::uint32_t next = r * sides + (k + 1) % sides;
        faces.push_back({here, next, next + sides, here + sides});
      }
    Face first;
    Face last;
    for (std::uint32_t k = 0; k < sides; ++k) {
      first.push_back(sides - 1 - k);
      last.push_back((rings - 1) * sides + k);
    }
    if (closed(ends, Ends::First)) faces.push_back(std::move(first));
    if (closed(ends, Ends::Last)) faces.push_back(std::move(last));
  }
};

void checkAdvance(double at, double before) {
  if (!(at > before)) refuse("each section must lie beyond the one before");
}

/// Corners of a section, counter-clockwise seen against the axis.
std::vector<Coord3> corners(Loft::Along along, const Loft::Section& s, double chamfer) {
  const double cut = chamfer * std::min(s.a, s.b);
  std::vector<Coord3> ring;
  // Signs of the corner, in the order around the section.
  for (const auto& sign : {std::array{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}) {
    const auto corner = [&](double less_a, double less_b) {
      ring.push_back(
          onAxes(along, s.at, s.centre_a + sign[0] * (s.a - less_a), s.centre_b + sign[1] * (s.b - less_b)));
    };
    const bool beside_first = sign[0] == sign[1];  // the corner's two ends in the order around the section
    if (cut > 0.0) corner(beside_first ? 0.0 : cut, beside_first ? cut : 0.0);
    corner(beside_first ? cut : 0.0, beside_first ? 0.0 : cut);
  }
  return ring;
}

}  // namespace

void Turned::setProfile(Loft::Along along, int sides, const std::vector<Ring>& rings, Ends ends) {
  if (rings.size() < 2 || sides < 3) refuse("a turned one has two rings and three sides or more");
  Stack stack;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (!(rings[i].radius > 0.0)) refuse("radii must be positive");
    if (i > 0) checkAdvance(rings[i].at, rings[i - 1].at);
    std::vector<Coord3> ring;
    for (int k = 0; k < sides; ++k) {
      const double angle = kTurn * k / sides;
      ring.push_back(
          onAxes(along, rings[i].at, rings[i].radius * std::cos(angle), rings[i].radius * std::sin(angle)));
    }
    stack.add(ring);
  }
  stack.close(static_cast<std::uint32_t>(sides), ends);
  setShape(std::move(stack.vertices), std::move(stack.faces), sides >= kRound);
  setCreaseAngle(kRoundBy);
}

void Milled::setSections(Loft::Along along, double chamfer, const std::vector<Loft::Section>& sections,
                         Ends ends) {
  if (sections.size() < 2) refuse("a milled one has two sections or more");
  if (!(chamfer >= 0.0 && chamfer < 1.0)) refuse("a chamfer is 0 to below 1");
  Stack stack;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (!(sections[i].a > 0.0) || !(sections[i].b > 0.0)) refuse("half extents must be positive");
    if (i > 0) checkAdvance(sections[i].at, sections[i - 1].at);
    stack.add(corners(along, sections[i], chamfer));
  }
  stack.close(chamfer > 0.0 ? 8 : 4, ends);
  setShape(std::move(stack.vertices), std::move(stack.faces));
}

void Milled::setBar(double length, double half_y, double half_z, Ends ends) {
  setSections(Loft::Along::X, 0.0, {{0.0, half_y, half_z}, {length, half_y, half_z}}, ends);
}

std::vector<Coord3> firstRing(const Polyhedron& part, std::size_t sides) {
  const std::vector<Coord3>& all = part.faces()->vertices;
  std::vector<Coord3> ring(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(sides));
  std::reverse(ring.begin(), ring.end());
  return ring;
}

std::vector<Coord3> lastRing(const Polyhedron& part, std::size_t sides) {
  const std::vector<Coord3>& all = part.faces()->vertices;
  return {all.end() - static_cast<std::ptrdiff_t>(sides), all.end()};
}

void Arc::setForm(Loft::Along along, const Form& form, Ends ends) {
  if (!(form.inner > 0.0 && form.outer > form.inner && form.half_width > 0.0))
    refuse("an arc has a thickness");
  if (!(form.to > form.from && form.to <= form.from + kTurn) || form.segments < 1)
    refuse("an arc goes on from its first angle, a turn at most");
  Stack stack;
  for (int i = 0; i <= form.segments; ++i) {
    const double angle = form.from + (form.to - form.from) * i / form.segments;
    const auto at = [&](double radius, double along_axis) {
      return onAxes(along, along_axis, radius * std::cos(angle), radius * std::sin(angle));
    };
    const double w = form.half_width;
    stack.add({at(form.outer, w), at(form.outer, -w), at(form.inner, -w), at(form.inner, w)});
  }
  stack.close(4, ends);
  setShape(std::move(stack.vertices), std::move(stack.faces));
}

}  // namespace coherency
