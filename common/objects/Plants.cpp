#include "common/objects/Plants.h"

#include <cmath>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

/// A leaf that grows from the origin upwards and bends over towards +z: a strip folded along its middle, seen
/// from both sides. Both halves fold the same way all along, which keeps every piece of them plane.
Faces leaf(double length, double width, double lean) {
  constexpr int kParts = 3;
  const Coord3 fold = 0.25 * Coord3{0.0, std::sin(1.4 * lean), -std::cos(1.4 * lean)};
  struct Rib {
    Coord3 left, middle, right;
  };
  std::array<Rib, kParts + 1> ribs;
  Coord3 at;
  for (int i = 0; i <= kParts; ++i) {
    const double along = static_cast<double>(i) / kParts;
    const double bend = lean + 0.85 * lean * along;  // from the vertical
    const double half = 0.5 * width * std::sin(0.5 * kTurn * (0.12 + 0.88 * along));
    ribs[static_cast<std::size_t>(i)] = {at + half * (fold - Coord3{1.0, 0.0, 0.0}), at,
                                         at + half * (fold + Coord3{1.0, 0.0, 0.0})};
    at += (length / kParts) * Coord3{0.0, std::cos(bend), std::sin(bend)};
  }
  Faces faces;
  const auto both = [&faces](const std::vector<Coord3>& corners) {
    faces.add(corners);
    faces.add({corners.rbegin(), corners.rend()});
  };
  for (std::size_t i = 0; i + 1 < kParts; ++i) {
    both({ribs[i].left, ribs[i].middle, ribs[i + 1].middle, ribs[i + 1].left});
    both({ribs[i].middle, ribs[i].right, ribs[i + 1].right, ribs[i + 1].middle});
  }
  const Coord3& tip = ribs[kParts].middle;
  both({ribs[kParts - 1].left, ribs[kParts - 1].middle, tip});
  both({ribs[kParts - 1].middle, ribs[kParts - 1].right, tip});
  return faces;
}

}  // namespace

Plant::Plant(double size) : VRObject("plant") {
  pot_.setTapered(0.13 * size, 0.18 * size, 0.34 * size, 12);
  assemble(*this, pot_, "plant pot", paint(0xC9CDC6, 0.2), {0.0, 0.17 * size, 0.0});
  soil_.setSize(0.165 * size, 0.02 * size, 12);
  assemble(*this, soil_, "plant soil", paint(0x4A3A2E), {0.0, 0.335 * size, 0.0});
  constexpr int kLeaves = 11;
  std::array<Faces, 2> tones;
  for (int i = 0; i < kLeaves; ++i) {
    const double length = (0.62 + 0.09 * ((i * 5) % 4)) * size;
    const double lean = 0.08 + 0.07 * ((i * 3) % 5);
    const TransformMatrix grown =
        TransformMatrix::translation(Coord3{0.0, 0.33, 0.0} * size) * TransformMatrix::rotationY(2.4 * i) *
        TransformMatrix::translation(Coord3{0.0, 0.0, 0.02 + 0.013 * (i % 4)} * size);
    tones[static_cast<std::size_t>(i % 2)].add(leaf(length, 0.10 * size, lean), grown);
  }
  constexpr std::array<std::uint32_t, 2> kGreens = {0x4F7F4A, 0x6A9A5B};
  for (std::size_t i = 0; i < tones.size(); ++i) {
    assembleFaces(*this, leaves_[i], "plant leaves", paint(kGreens[i], 0.2), tones[i]);
    leaves_[i].attach(finish::leaf());
  }
  attach(Solids{{{{0.0, 0.17 * size, 0.0}, {0.32 * size, 0.34 * size, 0.32 * size}}}});
}

Tree::Tree() : VRObject("tree") {
  trunk_.setTapered(0.16, 0.10, 1.8, 6);
  assemble(*this, trunk_, "tree trunk", finish::daylit(0x7A6653), {0.0, 0.9, 0.0});
  struct Part {
    Coord3 half, at;
    std::uint32_t colour;
    int sides;
  };
  constexpr std::array<Part, 2> kCrown = {{{{1.20, 1.30, 1.10}, {0.0, 2.65, 0.0}, 0x6F8F5B, 10},
                                           {{0.85, 0.75, 0.80}, {0.60, 2.15, 0.45}, 0x82A069, 8}}};
  for (std::size_t i = 0; i < crown_.size(); ++i) {
    crown_[i].setSize(kCrown[i].half, kCrown[i].sides);
    assemble(*this, crown_[i], "tree crown", finish::daylit(kCrown[i].colour), kCrown[i].at);
  }
}

}  // namespace coherency
