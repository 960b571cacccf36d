#include "common/objects/Door.h"

#include <utility>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Light.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

constexpr double kMiddle = -Wall::kThickness / 2;  // z of the plane in which a wall's two rooms meet
constexpr double kLeafThickness = 0.04;
constexpr double kLining = 0.015;  // how far a door's frame reaches into the opening
constexpr double kStub = 0.10;     // of an open leaf, stays in sight with its handle
static_assert(Door::kWidth - 2 * kLining - kStub >= Door::kClear - 1e-9);

/// What is in front of the leaf's middle plane, and the same behind it.
void assembleBothSides(VRObject& leaf, Polyhedron& part, std::string name, const Material& material,
                       Faces faces) {
  faces.mirror(0.0);
  assembleFaces(leaf, part, std::move(name), material, faces);
}

}  // namespace

Door::Door(const Outline& o) : VRObject("door") {
  buildFrame(o);
  const double width = o.width();
  const double height = o.top - 0.013;
  leaf_.setPosition((o.left + o.right) / 2, 0.008, kMiddle);
  leaf_.attach(Moving{});
  addMember(&leaf_);
  buildLeaf(width, height);
  buildSensors(o);
  const double way = width - 2 * kLining - kStub;
  attach(Doorway{&leaf_, {way, 0.0, 0.0}, {o.middle(kMiddle), {width, o.height(), kLeafThickness}}, 1.0});
  const double stub = kStub + kLining;
  attach(Solids{{{{o.right - stub / 2, o.top / 2, kMiddle}, {stub, o.top, kLeafThickness}}}});
  attach(finish::wood());
}

/// An architrave on the wall, a lining into the opening, and the strip of it that faces the leaf.
void Door::buildFrame(const Outline& o) {
  constexpr double kProud = 0.018;
  constexpr double kSlot = kMiddle + kLeafThickness / 2 + 0.005;
  const Outline inner = o.inset(kLining);
  const Outline outer = o.inset(-Wall::kArchitrave);
  Faces frame;
  frame.addFrame(outer, 0.0, outer, kProud);
  frame.addFrame(outer, kProud, inner, kProud);
  frame.addFrame(inner, kProud, inner, kSlot);
  frame.addFrame(inner, kSlot, o, kSlot);
  frame.mirror(kMiddle);
  assembleFaces(*this, frame_, "door frame", paint(finish::kTeal, 0.2), frame);

  constexpr double kFlat = Wall::kThickness / 2 + 0.01;
  constexpr double kTop = 0.004;
  Faces threshold;
  threshold.add({{inner.left, kTop, kMiddle + kFlat},
                 {inner.right, kTop, kMiddle + kFlat},
                 {inner.right, kTop, kMiddle - kFlat},
                 {inner.left, kTop, kMiddle - kFlat}});
  Faces edge;
  edge.add({{inner.left, 0.0, kMiddle + kFlat + 0.02},
            {inner.right, 0.0, kMiddle + kFlat + 0.02},
            {inner.right, kTop, kMiddle + kFlat},
            {inner.left, kTop, kMiddle + kFlat}});
  edge.mirror(kMiddle);
  threshold.add(edge, {});
  assembleFaces(*this, threshold_, "door threshold", paint(finish::kStainless, 0.4), threshold);
}

/// Its origin is in the middle of its lower edge; its left edge meets the frame, its right one is in the
/// wall.
void Door::buildLeaf(double width, double height) {
  constexpr double kFace = kLeafThickness / 2;
  const Outline whole{-width / 2 + 0.004, width / 2 + 0.01, 0.0, height};
  const Outline pane{-0.36, 0.36, 0.88, 1.86};
  Faces panel;
  panel.addFrame(whole, kFace, pane, kFace);
  panel.mirror(0.0);
  panel.add(Cuboid{{whole.width(), height, kLeafThickness},
                   whole.middle(0.0),
                   kNoRight | kNoBottom | kNoTop | kNoBack | kNoFront});
  assembleFaces(leaf_, panel_, "door panel", paint(0xB5875A, 0.15), panel);
  buildPane(pane);
  constexpr double kPlate = 0.003;
  Faces plates;
  const double plate_width = width - 0.24;  // both of its ends are in sight between the frame
  plates.add(Cuboid{{plate_width, 0.22, kPlate}, {0.0, 0.11, kFace + kPlate / 2}, kNoBack | kNoBottom});
  assembleBothSides(leaf_, kick_plates_, "door kick plates", paint(finish::kStainless, 0.5), plates);
  buildHandles(whole.left);
}

/// Glass: what one sees of it are its beads, the bands that keep people from running into it, and a label.
void Door::buildPane(const Outline& pane) {
  constexpr double kFace = kLeafThickness / 2;
  const Outline glass = pane.inset(0.016);
  Faces beads;
  beads.addFrame(pane, kFace, glass, 0.0);
  assembleBothSides(leaf_, beads_, "door glazing beads", paint(finish::kStainless, 0.4), beads);
  Faces bands;
  for (const double y : {1.24, 1.30, 1.36}) bands.addSheet({glass.left, glass.right, y, y + 0.03}, 0.001);
  assembleBothSides(leaf_, bands_, "door pane bands", paint(0xE9F0F0, 0.3), bands);
  const Coord3 middle{0.0, 1.60, 0.001};
  Faces label;
  label.addDisc(middle, 0.075, 20);
  assembleBothSides(leaf_, label_, "door label", paint(finish::kTeal, 0.2), label);
  Faces arrow;
  const double z = 0.003;
  arrow.addSheet({-0.045, 0.005, middle.y - 0.012, middle.y + 0.012}, z);
  arrow.add({{0.005, middle.y - 0.036, z}, {0.05, middle.y, z}, {0.005, middle.y + 0.036, z}});
  assembleBothSides(leaf_, arrow_, "door arrow", paint(finish::kPaper), arrow);
}

void Door::buildHandles(double edge) {
  constexpr double kFace = kLeafThickness / 2;
  constexpr double kOut = 0.052;
  const Material metal = paint(finish::kStainless, 0.7);
  constexpr double kHigh = 1.02;
  const double x = edge + 0.055;
  Faces posts;
  for (const double y : {kHigh - 0.14, kHigh + 0.14})
    posts.add(Cuboid{{0.014, 0.014, kOut - kFace}, {x, y, (kOut + kFace) / 2}, kNoFront | kNoBack});
  assembleBothSides(leaf_, handle_posts_, "door handle posts", metal, posts);
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    handles_[i].setSize(0.011, 0.40, 12);
    assemble(leaf_, handles_[i], "door handle", metal, {x, kHigh, i == 0 ? kOut : -kOut});
  }
}

/// Over the frame, with an eye that looks down at who comes and a lamp that shows it is awake.
void Door::buildSensors(const Outline& o) {
  const double x = (o.left + o.right) / 2;
  const double y = o.top + Wall::kArchitrave + 0.055;
  const auto assembleSensor = [&](Polyhedron& part, const char* name, const Material& material, Faces faces) {
    faces.mirror(kMiddle);
    assembleFaces(*this, part, name, material, faces);
  };
  Faces box;
  box.add(Cuboid{{0.22, 0.06, 0.05}, {x, y, 0.025}, kNoBack});
  assembleSensor(sensors_, "door sensors", paint(finish::kBlack, 0.3), box);
  Faces eye;
  eye.addSheet({x - 0.05, x + 0.05, y - 0.02, y + 0.008}, 0.052);
  assembleSensor(sensor_eyes_, "door sensor eyes", paint(0x6E2A2A, 0.8), eye);
  Faces lamp;
  lamp.addSheet({x + 0.07, x + 0.085, y - 0.006, y + 0.009}, 0.052);
  assembleSensor(sensor_lamps_, "door sensor lamps", glow(0x5FE08A), lamp);
}

}  // namespace coherency
