#include "common/world/Room.h"

#include <algorithm>
#include <utility>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

using Faces = std::vector<std::vector<std::uint32_t>>;

constexpr double kSkirtingHeight = 0.09;
constexpr double kSkirtingDepth = 0.014;

std::uint32_t append(std::vector<Coord3>& vertices, const Coord3& vertex) {
  vertices.push_back(vertex);
  return static_cast<std::uint32_t>(vertices.size() - 1);
}

void appendQuad(std::vector<Coord3>& vertices, Faces& faces, const std::array<Coord3, 4>& corners) {
  std::vector<std::uint32_t> face;
  face.reserve(corners.size());
  for (const Coord3& corner : corners) face.push_back(append(vertices, corner));
  faces.push_back(std::move(face));
}

bool within(const Wall::Opening& opening, double x, double y) {
  return x > opening.left && x < opening.right && y > opening.bottom && y < opening.top;
}

std::vector<double> sortedCuts(std::vector<double> cuts) {
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// The four inner sides of an opening, as deep as the wall; no side at the floor.
void appendReveals(std::vector<Coord3>& vertices, Faces& faces, const Wall::Opening& o) {
  const double back = -Wall::kThickness;
  const auto quad = [&](const std::array<Coord3, 4>& corners) { appendQuad(vertices, faces, corners); };
  quad({{{o.left, o.bottom, 0}, {o.left, o.bottom, back}, {o.left, o.top, back}, {o.left, o.top, 0}}});
  quad({{{o.right, o.bottom, back}, {o.right, o.bottom, 0}, {o.right, o.top, 0}, {o.right, o.top, back}}});
  quad({{{o.left, o.top, 0}, {o.left, o.top, back}, {o.right, o.top, back}, {o.right, o.top, 0}}});
  if (o.bottom > 0.0)
    quad({{{o.left, o.bottom, back},
           {o.left, o.bottom, 0},
           {o.right, o.bottom, 0},
           {o.right, o.bottom, back}}});
}

}  // namespace

Floor::Floor(int tiles_x, int tiles_z, double tile) : VRObject("floor") {
  std::array<std::vector<Coord3>, 2> vertices;
  std::array<Faces, 2> faces;
  for (int i = 0; i < tiles_x; ++i) {
    for (int k = 0; k < tiles_z; ++k) {
      const double x = (i - tiles_x / 2.0) * tile;
      const double z = (k - tiles_z / 2.0) * tile;
      const auto tone = static_cast<std::size_t>((i + k) % 2);
      appendQuad(vertices[tone], faces[tone],
                 {{{x, 0, z}, {x, 0, z + tile}, {x + tile, 0, z + tile}, {x + tile, 0, z}}});
    }
  }
  light_.setShape(std::move(vertices[0]), std::move(faces[0]));
  dark_.setShape(std::move(vertices[1]), std::move(faces[1]));
  assemble(*this, light_, "light tiles", paint(0xC2B49F, 0.12));
  assemble(*this, dark_, "dark tiles", paint(0xB1A28C, 0.12));
}

Ceiling::Ceiling(double width, double depth) : VRObject("ceiling") {
  board_.setSize(width, depth);
  assemble(*this, board_, "ceiling board", paint(0xF2EFE8));
  board_.setOrientation(TransformMatrix::rotationX(kTurn / 4));
}

CeilingLamp::CeilingLamp(double width, double depth) : VRObject("ceiling lamp") {
  assembleBox(*this, frame_, "lamp frame", paint(0xD9D6CF), {width + 0.05, 0.035, depth + 0.05},
              {0.0, -0.0175, 0.0});
  assembleBox(*this, panel_, "lamp panel", glow(0xFFFDF6), {width, 0.02, depth}, {0.0, -0.03, 0.0});
}

Wall::Wall(const Form& form, std::string name) : VRObject(std::move(name)) {
  buildSurface(form);
  buildSkirting(form);
}

/// A grid through the edges of all openings, without the cells that are open: no edge ends in the middle of
/// another, so no light shines through the joints.
void Wall::buildSurface(const Form& form) {
  std::vector<double> xs = {-form.width / 2, form.width / 2};
  std::vector<double> ys = {0.0, form.height};
  std::vector<Coord3> vertices;
  Faces faces;
  for (const Opening& o : form.openings) {
    xs.insert(xs.end(), {o.left, o.right});
    ys.insert(ys.end(), {o.bottom, o.top});
    appendReveals(vertices, faces, o);
  }
  xs = sortedCuts(std::move(xs));
  ys = sortedCuts(std::move(ys));
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
      const double x = (xs[i] + xs[i + 1]) / 2;
      const double y = (ys[k] + ys[k + 1]) / 2;
      const auto open = [&](const Opening& o) { return within(o, x, y); };
      if (std::any_of(form.openings.begin(), form.openings.end(), open)) continue;
      appendQuad(
          vertices, faces,
          {{{xs[i], ys[k], 0}, {xs[i + 1], ys[k], 0}, {xs[i + 1], ys[k + 1], 0}, {xs[i], ys[k + 1], 0}}});
    }
  }
  surface_.setShape(std::move(vertices), std::move(faces));
  assemble(*this, surface_, name() + " surface", paint(form.colour));
}

void Wall::buildSkirting(const Form& form) {
  const double end = form.width / 2 - form.skirting_inset;
  const auto board = [&](std::size_t i, double from, double to) {
    assembleBox(*this, skirting_[i], name() + " skirting", paint(0x8C7A66, 0.1),
                {to - from, kSkirtingHeight, kSkirtingDepth},
                {(from + to) / 2, kSkirtingHeight / 2, kSkirtingDepth / 2});
  };
  const auto door = std::find_if(form.openings.begin(), form.openings.end(),
                                 [](const Opening& o) { return o.bottom <= 0.0; });
  if (door == form.openings.end()) {
    board(0, -end, end);
    return;
  }
  constexpr double kArchitrave = 0.07;  // Door.cpp's
  board(0, -end, door->left - kArchitrave);
  board(1, door->right + kArchitrave, end);
}

}  // namespace coherency
