#include "common/body/Loft.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace coherency {

namespace {

using Section = Loft::Section;
using Faces = std::vector<std::vector<std::uint32_t>>;

constexpr double kCrease = 1.0;  // rad: flat ends stay sharp, everything else is smooth

void check(const std::vector<Section>& sections, const Loft::Form& form) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument("Loft: " + what); };
  if (sections.size() < 2) refuse("needs two sections or more");
  if (form.sides < 3) refuse("needs three sides or more");
  if (!(form.squareness > 1.0)) refuse("squareness must be above 1");
  if (!(form.dome_first >= 0.0) || !(form.dome_last >= 0.0)) refuse("a dome's length must not be negative");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string where = "section " + std::to_string(i);
    if (!(sections[i].a > 0.0) || !(sections[i].b > 0.0)) refuse(where + " must have positive half extents");
    if (i > 0 && !(sections[i].at > sections[i - 1].at)) refuse(where + " must lie beyond the one before");
  }
}

/// Rings of a dome over `base`, from the base outward, without base and pole.
std::vector<Section> domeRings(const Section& base, double length) {
  std::vector<Section> rings;
  for (const double degrees : {32.0, 62.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    Section ring = base;
    ring.at += length * std::sin(angle);
    ring.a *= std::cos(angle);
    ring.b *= std::cos(angle);
    rings.push_back(ring);
  }
  return rings;
}

std::vector<Section> withDomes(const std::vector<Section>& sections, const Loft::Form& form) {
  std::vector<Section> all;
  if (form.dome_first > 0.0) {
    const auto rings = domeRings(sections.front(), -form.dome_first);
    all.assign(rings.rbegin(), rings.rend());
  }
  all.insert(all.end(), sections.begin(), sections.end());
  if (form.dome_last > 0.0) {
    const auto rings = domeRings(sections.back(), form.dome_last);
    all.insert(all.end(), rings.begin(), rings.end());
  }
  return all;
}

/// Half of a superellipse's point whose outward normal has the components c and s: the one along c.
double ovalPoint(double half, double c, double other_half, double s, double n) {
  const double p = n / (n - 1.0);
  const double u = half * std::abs(c);
  const double v = other_half * std::abs(s);
  const double sum = std::pow(u, p) + std::pow(v, p);
  return std::copysign(half * std::pow(u, p - 1.0) / std::pow(sum, 1.0 / n), c);
}

void appendRing(std::vector<Coord3>& vertices, const Section& s, const Loft::Form& form) {
  for (int k = 0; k < form.sides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / form.sides;
    const double c = std::cos(angle);
    const double d = std::sin(angle);
    vertices.push_back(onAxes(form.along, s.at, s.centre_a + ovalPoint(s.a, c, s.b, d, form.squareness),
                              s.centre_b + ovalPoint(s.b, d, s.a, c, form.squareness)));
  }
}

/// Closes the ring that begins at vertex `ring`: with a fan to a pole where there is a dome, flat otherwise.
/// `last` is the end that faces along the axis.
void appendEnd(std::vector<Coord3>& vertices, Faces& faces, std::uint32_t ring, const Section& section,
               const Loft::Form& form, bool last) {
  const auto sides = static_cast<std::uint32_t>(form.sides);
  const double dome = last ? form.dome_last : form.dome_first;
  if (dome > 0.0) {
    const auto pole = static_cast<std::uint32_t>(vertices.size());
    const double at = section.at + (last ? dome : -dome);
    vertices.push_back(onAxes(form.along, at, section.centre_a, section.centre_b));
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t here = ring + k;
      const std::uint32_t next = ring + (k + 1) % sides;
      if (last) faces.push_back({here, next, pole});
      if (!last) faces.push_back({next, here, pole});
    }
    return;
  }
  std::vector<std::uint32_t> cap;
  for (std::uint32_t k = 0; k < sides; ++k) cap.push_back(ring + (last ? k : sides - 1 - k));
  faces.push_back(std::move(cap));
}

}  // namespace

Coord3 onAxes(Loft::Along along, double at, double a, double b) {
  switch (along) {
    case Loft::Along::X:
      return {at, a, b};
    case Loft::Along::Y:
      return {b, at, a};
    case Loft::Along::Z:
      break;
  }
  return {a, b, at};
}

void Loft::setSections(const std::vector<Section>& sections, const Form& form) {
  check(sections, form);
  const std::vector<Section> rings = withDomes(sections, form);
  const auto sides = static_cast<std::uint32_t>(form.sides);
  std::vector<Coord3> vertices;
  Faces faces;
  for (const Section& ring : rings) appendRing(vertices, ring, form);
  // Triangles: a quadrilateral between ovals of different proportions is not plane.
  for (std::uint32_t i = 0; i + 1 < rings.size(); ++i) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t low = i * sides + k;
      const std::uint32_t low_next = i * sides + (k + 1) % sides;
      faces.push_back({low, low_next, low_next + sides});
      faces.push_back({low, low_next + sides, low + sides});
    }
  }
  appendEnd(vertices, faces, 0, sections.front(), form, false);
  const auto last_ring = static_cast<std::uint32_t>(rings.size() - 1) * sides;
  appendEnd(vertices, faces, last_ring, sections.back(), form, true);
  setShape(std::move(vertices), std::move(faces), true);
  setCreaseAngle(kCrease);
}

}  // namespace coherency
