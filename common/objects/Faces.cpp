#include "common/objects/Faces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

std::vector<double> sortedCuts(std::vector<double> cuts) {
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

bool holds(const Outline& hole, double x, double y) {
  return x > hole.left && x < hole.right && y > hole.bottom && y < hole.top;
}

/// Corners of a cuboid's side, counter-clockwise from outside, as indices whose bits 0, 1, 2 say +x, +y, +z.
constexpr std::array<std::pair<unsigned, std::array<unsigned, 4>>, 6> kSides = {{{kNoLeft, {0, 4, 6, 2}},
                                                                                 {kNoRight, {1, 3, 7, 5}},
                                                                                 {kNoBottom, {0, 1, 5, 4}},
                                                                                 {kNoTop, {2, 6, 7, 3}},
                                                                                 {kNoBack, {0, 2, 3, 1}},
                                                                                 {kNoFront, {4, 5, 7, 6}}}};

}  // namespace

std::vector<Cuboid> row(const Cuboid& first, const Coord3& step, int count) {
  std::vector<Cuboid> all(static_cast<std::size_t>(count), first);
  for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)].centre += static_cast<double>(i) * step;
  return all;
}

void Faces::add(const std::vector<Coord3>& corners) {
  std::vector<std::uint32_t> face;
  face.reserve(corners.size());
  for (const Coord3& corner : corners) {
    face.push_back(static_cast<std::uint32_t>(vertices_.size()));
    vertices_.push_back(corner);
  }
  faces_.push_back(std::move(face));
}

void Faces::add(const Cuboid& cuboid) {
  const Coord3 half = 0.5 * cuboid.size;
  const auto corner = [&](unsigned bits) {
    return cuboid.centre + Coord3{(bits & 1U) != 0 ? half.x : -half.x, (bits & 2U) != 0 ? half.y : -half.y,
                                  (bits & 4U) != 0 ? half.z : -half.z};
  };
  for (const auto& [side, corners] : kSides)
    if ((cuboid.hidden & side) == 0)
      add({corner(corners[0]), corner(corners[1]), corner(corners[2]), corner(corners[3])});
}

void Faces::add(const Faces& others, const TransformMatrix& t_this_others) {
  for (const auto& face : others.faces_) {
    std::vector<Coord3> corners;
    corners.reserve(face.size());
    for (const std::uint32_t i : face) corners.push_back(t_this_others.point(others.vertices_[i]));
    add(corners);
  }
}

void Faces::addSheet(const Outline& o, double z, const std::vector<Outline>& holes) {
  std::vector<double> xs = {o.left, o.right};
  std::vector<double> ys = {o.bottom, o.top};
  const auto cut = [](std::vector<double>& cuts, double at, double from, double to) {
    if (at > from && at < to) cuts.push_back(at);
  };
  for (const Outline& hole : holes) {
    for (const double x : {hole.left, hole.right}) cut(xs, x, o.left, o.right);
    for (const double y : {hole.bottom, hole.top}) cut(ys, y, o.bottom, o.top);
  }
  xs = sortedCuts(std::move(xs));
  ys = sortedCuts(std::move(ys));
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
      const auto open = [&](const Outline& hole) {
        return holds(hole, 0.5 * (xs[i] + xs[i + 1]), 0.5 * (ys[k] + ys[k + 1]));
      };
      if (std::any_of(holes.begin(), holes.end(), open)) continue;
      add({{xs[i], ys[k], z}, {xs[i + 1], ys[k], z}, {xs[i + 1], ys[k + 1], z}, {xs[i], ys[k + 1], z}});
    }
  }
}

void Faces::addFrame(const Outline& outer, double z_outer, const Outline& inner, double z_inner) {
  const std::array<Coord3, 4> a = {{{outer.left, outer.bottom, z_outer},
                                    {outer.right, outer.bottom, z_outer},
                                    {outer.right, outer.top, z_outer},
                                    {outer.left, outer.top, z_outer}}};
  const std::array<Coord3, 4> b = {{{inner.left, inner.bottom, z_inner},
                                    {inner.right, inner.bottom, z_inner},
                                    {inner.right, inner.top, z_inner},
                                    {inner.left, inner.top, z_inner}}};
  const bool on_floor = outer.standsOnFloor() && inner.standsOnFloor();
  for (std::size_t i = on_floor ? 1 : 0; i < a.size(); ++i) {
    const std::size_t next = (i + 1) % a.size();
    add({a[i], a[next], b[next], b[i]});
  }
}

void Faces::addStroke(const Coord3& middle, double width, double height, double turn) {
  Faces stroke;
  stroke.addSheet(Outline::centred(width, height), 0.0);
  add(stroke, TransformMatrix::translation(middle) * TransformMatrix::rotationZ(turn));
}

void Faces::addDisc(const Coord3& middle, double radius, int sides) {
  std::vector<Coord3> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = kTurn * i / sides;
    corners.push_back(middle + Coord3{radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  add(corners);
}

void Faces::mirror(double z) {
  const std::vector<std::vector<std::uint32_t>> faces = faces_;
  for (const auto& face : faces) {
    std::vector<Coord3> corners;
    corners.reserve(face.size());
    for (const std::uint32_t i : face) {
      const Coord3& v = vertices_[i];
      corners.push_back({v.x, v.y, 2.0 * z - v.z});
    }
    std::reverse(corners.begin(), corners.end());
    add(corners);
  }
}

Faces pictureFrame(const Outline& inner, double board, double proud) {
  const Outline outer{inner.left - board, inner.right + board, inner.bottom - board, inner.top + board};
  Faces frame;
  frame.addFrame(outer, 0.0, outer, proud);
  frame.addFrame(outer, proud, inner, proud);
  frame.addFrame(inner, proud, inner, proud - 0.008);
  return frame;
}

void assembleFaces(VRObject& owner, Polyhedron& part, std::string name, const Material& material,
                   const Faces& faces, const Coord3& at) {
  faces.shape(part);
  assemble(owner, part, std::move(name), material, at);
}

void assembleSheet(VRObject& owner, Rectangle& part, std::string name, const Material& material,
                   const Outline& outline, double z) {
  part.setSize(outline.width(), outline.height());
  assemble(owner, part, std::move(name), material, outline.middle(z));
}

void assembleBoxes(VRObject& owner, Polyhedron& part, std::string name, const Material& material,
                   const std::vector<Cuboid>& boxes) {
  Faces faces;
  for (const Cuboid& box : boxes) faces.add(box);
  assembleFaces(owner, part, std::move(name), material, faces);
}

}  // namespace coherency
