#include "common/objects/Room.h"

#include <cmath>

#include "common/body/Palette.h"
#include "common/objects/Finish.h"
#include "common/scene/Enclosure.h"

namespace coherency {

namespace {

// Floors go on a little under the walls, and ceilings over them, so that no light shines through the joints.
constexpr double kUnderWall = 0.01;

/// From above, as a sheet in the xy plane seen from +z is.
const TransformMatrix kLevel = TransformMatrix::rotationX(-kTurn / 4);

Wall::Form wallOf(Wall::Form form, double width, double height, double skirting_inset) {
  form.width = width;
  form.height = height;
  form.skirting_inset = skirting_inset;
  return form;
}

/// How many tiles reach from the middle to an edge. The last one is cut there, or, where only a strip would
/// be left over, is that much longer.
int tilesTo(double edge, double tile) {
  constexpr double kStrip = 0.05;
  return static_cast<int>(std::ceil((edge - kStrip) / tile));
}

Faces level(const Faces& sheets) {
  Faces floor;
  floor.add(sheets, kLevel);
  return floor;
}

void addOpenings(Enclosure& enclosure, const Wall::Form& wall, const VRObject& placed) {
  const TransformMatrix& t_room_wall = placed.transform();
  for (const Outline& o : wall.openings)
    enclosure.openings.push_back(
        {t_room_wall.point({o.left, o.bottom, 0.0}), t_room_wall.point({o.right, o.bottom, 0.0}),
         t_room_wall.point({o.right, o.top, 0.0}), t_room_wall.point({o.left, o.top, 0.0})});
}

}  // namespace

void put(VRObject& owner, VRObject& part, const Coord3& at, double turn) {
  part.setPosition(at);
  part.setOrientation(TransformMatrix::rotationY(turn));
  owner.addMember(&part);
}

TiledFloor::TiledFloor(double width, double depth, double tile, std::uint32_t light, std::uint32_t dark,
                       double gloss)
    : VRObject("floor") {
  const double half_x = width / 2 + kUnderWall;
  const double half_z = depth / 2 + kUnderWall;
  const int columns = tilesTo(half_x, tile);
  const int rows = tilesTo(half_z, tile);
  std::array<Faces, 2> tones;
  for (int i = -columns; i < columns; ++i)
    for (int k = -rows; k < rows; ++k)
      tones[static_cast<std::size_t>((i + k) & 1)].addSheet(
          {i == -columns ? -half_x : i * tile, i + 1 == columns ? half_x : (i + 1) * tile,
           k == -rows ? -half_z : k * tile, k + 1 == rows ? half_z : (k + 1) * tile},
          0.0);
  assembleFaces(*this, light_, "light tiles", paint(light, gloss), level(tones[0]));
  assembleFaces(*this, dark_, "dark tiles", paint(dark, gloss), level(tones[1]));
}

BorderedFloor::BorderedFloor(double width, double depth, double border, std::uint32_t field,
                             std::uint32_t edge)
    : VRObject("floor") {
  const double half_x = width / 2 + kUnderWall;
  const double half_z = depth / 2 + kUnderWall;
  const Outline whole{-half_x, half_x, -half_z, half_z};
  const Outline inner{-width / 2 + border, width / 2 - border, -depth / 2 + border, depth / 2 - border};
  Faces sheet;
  sheet.addSheet(inner, 0.0);
  assembleFaces(*this, field_, "floor field", paint(field, 0.12), level(sheet));
  Faces rim;
  rim.addSheet(whole, 0.0, {inner});
  assembleFaces(*this, edge_, "floor edge", paint(edge, 0.12), level(rim));
}

Shell::Shell(const Form& f)
    : VRObject("shell"),
      front_(wallOf(f.front, f.width, f.height, 0.0), "front wall"),
      back_(wallOf(f.back, f.width, f.height, 0.0), "back wall"),
      left_(wallOf(f.left, f.depth, f.height, Wall::kSkirtingDepth), "left wall"),
      right_(wallOf(f.right, f.depth, f.height, Wall::kSkirtingDepth), "right wall") {
  put(*this, front_, {0.0, 0.0, -f.depth / 2}, kFacesBack);
  put(*this, back_, {0.0, 0.0, f.depth / 2}, kFacesFront);
  put(*this, left_, {-f.width / 2, 0.0, 0.0}, kFacesRight);
  put(*this, right_, {f.width / 2, 0.0, 0.0}, kFacesLeft);
  ceiling_.setSize(f.width + 2 * kUnderWall, f.depth + 2 * kUnderWall);
  assemble(*this, ceiling_, "ceiling", paint(finish::kCeiling), {0.0, f.height, 0.0});
  ceiling_.setOrientation(TransformMatrix::rotationX(kTurn / 4));
  Enclosure enclosure{{0.0, f.height / 2, 0.0}, {f.width, f.height, f.depth}, {}};
  addOpenings(enclosure, f.front, front_);
  addOpenings(enclosure, f.back, back_);
  addOpenings(enclosure, f.left, left_);
  addOpenings(enclosure, f.right, right_);
  attach(std::move(enclosure));
}

}  // namespace coherency
