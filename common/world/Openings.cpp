#include "common/world/Openings.h"

#include <cmath>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr std::uint32_t kFrameColour = 0xF1EEE7;

/// A daylit surface: mostly its own light, so that the room's lamps change little.
Material daylight(std::uint32_t srgb) {
  Material material = paint(srgb);
  material.emission = 0.75;
  return material;
}

/// A silhouette of hills as wide as it is far: a strip of quadrilaterals in the xy plane.
void shapeHills(Polyhedron& hills, double width, double base, double height, double phase) {
  constexpr int kSteps = 24;
  std::vector<Coord3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = width * (static_cast<double>(i) / kSteps - 0.5);
    const double s = x / width * kTurn;
    const double y =
        base + height * (0.5 + 0.28 * std::sin(2.0 * s + phase) + 0.2 * std::sin(5.0 * s + 2.0 * phase));
    vertices.push_back({x, -1.0, 0.0});
    vertices.push_back({x, y, 0.0});
    const auto k = static_cast<std::uint32_t>(2 * i);
    if (i < kSteps) faces.push_back({k, k + 2, k + 3, k + 1});
  }
  hills.setShape(std::move(vertices), std::move(faces));
}

}  // namespace

Window::Window(const Wall::Opening& o) : VRObject("window") {
  constexpr double kBar = 0.055;
  constexpr double kDepth = 0.06;
  constexpr double kBack = -0.09;
  const double width = o.right - o.left;
  const double height = o.top - o.bottom;
  const Material white = paint(kFrameColour, 0.15);
  const double x = (o.left + o.right) / 2;
  const double y = (o.bottom + o.top) / 2;
  const Coord3 upright{kBar, height, kDepth};
  const Coord3 across{width - 2 * kBar, kBar, kDepth};
  assembleBox(*this, frame_[0], "window frame left", white, upright, {o.left + kBar / 2, y, kBack});
  assembleBox(*this, frame_[1], "window frame right", white, upright, {o.right - kBar / 2, y, kBack});
  assembleBox(*this, frame_[2], "window frame bottom", white, across, {x, o.bottom + kBar / 2, kBack});
  assembleBox(*this, frame_[3], "window frame top", white, across, {x, o.top - kBar / 2, kBack});
  assembleBox(*this, mullion_, "window mullion", white, {0.035, height - 2 * kBar, kDepth - 0.01},
              {x, y, kBack});
  assembleBox(*this, sill_, "window sill", paint(0xDDD5C8, 0.2), {width + 0.08, 0.03, 0.17},
              {x, o.bottom - 0.012, 0.025});
}

Door::Door(const Wall::Opening& o) : VRObject("door") {
  constexpr double kArchitrave = 0.07;
  const double width = o.right - o.left;
  const double height = o.top - o.bottom;
  const double x = (o.left + o.right) / 2;
  const Material wood = paint(0x9A6B45, 0.15);
  const Material trim = paint(0x7C5638, 0.15);
  assembleBox(*this, leaf_, "door leaf", wood, {width, height - 0.01, 0.045}, {x, height / 2 + 0.005, -0.04});
  assembleBox(*this, pane_, "door pane", glow(0xBFD3DA), {0.14, 0.85, 0.006},
              {x + width * 0.28, 1.45, -0.016});
  assembleBox(*this, kick_plate_, "door kick plate", paint(palette::kMetal, 0.5), {width - 0.06, 0.2, 0.004},
              {x, 0.13, -0.016});
  const Coord3 upright{kArchitrave, height, 0.025};
  assembleBox(*this, architrave_[0], "door architrave left", trim, upright,
              {o.left - kArchitrave / 2, height / 2, 0.0125});
  assembleBox(*this, architrave_[1], "door architrave right", trim, upright,
              {o.right + kArchitrave / 2, height / 2, 0.0125});
  assembleBox(*this, architrave_[2], "door architrave top", trim,
              {width + 2 * kArchitrave, kArchitrave, 0.025}, {x, o.top + kArchitrave / 2, 0.0125});
  handle_.setSize(0.010, 0.13, 10);
  assemble(*this, handle_, "door handle", paint(palette::kMetal, 0.7), {o.left + 0.135, 1.03, 0.03});
  handle_.setOrientation(TransformMatrix::rotationZ(kTurn / 4));
  handle_neck_.setSize(0.012, 0.05, 10);
  assemble(*this, handle_neck_, "door handle neck", paint(palette::kMetal, 0.7),
           {o.left + 0.08, 1.03, 0.005});
  handle_neck_.setOrientation(TransformMatrix::rotationX(kTurn / 4));
}

Tree::Tree() : VRObject("tree") {
  trunk_.setTapered(0.16, 0.10, 1.8, 10);
  assemble(*this, trunk_, "tree trunk", daylight(0x7A6653), {0.0, 0.9, 0.0});
  crown_.setSize({1.15, 1.35, 1.1}, 14);
  assemble(*this, crown_, "tree crown", daylight(0x6F8F5B), {0.0, 2.6, 0.0});
  crown_beside_.setSize({0.8, 0.85, 0.8}, 12);
  assemble(*this, crown_beside_, "tree crown beside", daylight(0x7D9C66), {0.65, 2.1, 0.4});
}

Outdoors::Outdoors() : VRObject("outdoors") {
  constexpr double kFar = -38.0;
  lawn_.setSize(80.0, 37.0);
  assemble(*this, lawn_, "lawn", daylight(0x9DB27F), {0.0, -0.4, -19.0});
  lawn_.setOrientation(TransformMatrix::rotationX(-kTurn / 4));
  path_.setSize(70.0, 1.6);
  assemble(*this, path_, "path", daylight(0xD6CBB4), {0.0, -0.37, -10.5});
  path_.setOrientation(TransformMatrix::rotationX(-kTurn / 4));
  shapeHills(near_hills_, 90.0, 0.6, 3.0, 0.4);
  assemble(*this, near_hills_, "near hills", daylight(0x8CA587), {0.0, 0.0, kFar + 1.0});
  shapeHills(far_hills_, 95.0, 2.2, 5.0, 2.1);
  assemble(*this, far_hills_, "far hills", daylight(0xA9BCC0), {0.0, 0.0, kFar});
  constexpr std::array<std::uint32_t, kSkyBands> kSky = {0xE6EEF0, 0xDCE9F0, 0xCFE1EE,
                                                         0xC1D9EB, 0xB3D0E8, 0xA5C7E4};
  constexpr double kBand = 5.0;
  for (std::size_t i = 0; i < kSkyBands; ++i) {
    sky_[i].setSize(110.0, kBand);
    assemble(*this, sky_[i], "sky band", glow(kSky[i]),
             {0.0, -1.0 + kBand * (static_cast<double>(i) + 0.5), kFar - 1.0});
  }
  constexpr std::array<Coord3, 4> kTrees = {
      {{-7.2, -0.4, -13.0}, {-2.6, -0.4, -17.0}, {2.2, -0.4, -14.0}, {6.4, -0.4, -12.5}}};
  for (std::size_t i = 0; i < trees_.size(); ++i) {
    trees_[i].setPosition(kTrees[i]);
    trees_[i].setOrientation(TransformMatrix::rotationY(1.3 * static_cast<double>(i)));
    addMember(&trees_[i]);
  }
}

}  // namespace coherency
