#include "common/objects/Seating.h"

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

void assemblePad(VRObject& owner, Pad& pad, const std::string& name, std::uint32_t colour, const Coord3& at,
                 double lean = 0.0) {
  assemble(owner, pad, name, paint(colour), at);
  pad.setOrientation(TransformMatrix::rotationX(lean));
  pad.attach(finish::cushion());
}

}  // namespace

Chair::Chair(std::uint32_t colour) : VRObject("chair") {
  constexpr double kSeat = 0.45;
  constexpr double kHalf = 0.23;
  seat_.setSize({2 * kHalf, 0.05, 2 * kHalf}, Pad::Thick::Y);
  assemblePad(*this, seat_, "chair seat", colour, {0.0, kSeat - 0.025, 0.0});
  back_.setSize({2 * kHalf - 0.02, 0.34, 0.04}, Pad::Thick::Z);
  assemblePad(*this, back_, "chair back", colour, {0.0, 0.70, -0.235}, -0.12);
  std::vector<Cuboid> frame;
  for (const double x : {-0.20, 0.20}) {
    frame.push_back({{0.022, kSeat - 0.04, 0.022}, {x, (kSeat - 0.04) / 2, 0.19}, kNoBottom | kNoTop});
    frame.push_back({{0.022, 0.70, 0.022}, {x, 0.35, -0.205}, kNoBottom});
    frame.push_back({{0.018, 0.02, 0.37}, {x, kSeat - 0.06, -0.01}, kNoFront | kNoBack});
  }
  assembleBoxes(*this, frame_, "chair frame", paint(finish::kSteel, 0.4), frame);
  attach(Solids{{{{0.0, kSeat / 2, 0.0}, {0.46, kSeat, 0.44}}, {{0.0, 0.68, -0.225}, {0.46, 0.40, 0.05}}}});
}

SwivelChair::SwivelChair(std::uint32_t colour) : VRObject("swivel chair") {
  constexpr double kSeat = 0.47;
  const Material black = paint(finish::kBlack, 0.3);
  seat_.setSize({0.48, 0.07, 0.46}, Pad::Thick::Y);
  assemblePad(*this, seat_, "swivel chair seat", colour, {0.0, kSeat - 0.035, 0.0});
  back_.setSize({0.44, 0.54, 0.06}, Pad::Thick::Z);
  assemblePad(*this, back_, "swivel chair back", colour, {0.0, 0.79, -0.245}, -0.10);
  assembleBoxes(
      *this, spine_, "swivel chair spine", black,
      {{{0.07, 0.025, 0.26}, {0.0, kSeat - 0.085, -0.16}}, {{0.07, 0.34, 0.03}, {0.0, 0.55, -0.285}}});
  column_.setTapered(0.045, 0.028, 0.30, 12);
  assemble(*this, column_, "swivel chair column", black, {0.0, 0.23, 0.0});
  Faces arm;
  arm.add(Cuboid{{0.045, 0.03, 0.30}, {0.0, 0.085, 0.15}, kNoBack});
  arm.add(Cuboid{{0.03, 0.07, 0.05}, {0.0, 0.035, 0.27}, kNoTop | kNoBottom});
  Faces star;
  for (int i = 0; i < 5; ++i) star.add(arm, TransformMatrix::rotationY(kTurn * i / 5));
  assembleFaces(*this, star_, "swivel chair star", black, star);
  attach(Solids{{{{0.0, kSeat / 2, 0.0}, {0.48, kSeat, 0.46}}, {{0.0, 0.76, -0.25}, {0.44, 0.58, 0.07}}}});
}

Bench::Bench() : VRObject("bench") {
  constexpr double kSlat = 0.035;
  std::vector<Cuboid> slats;
  for (const double z : {-0.135, 0.0, 0.135})
    slats.push_back({{kWidth, kSlat, 0.12}, {0.0, kHeight - kSlat / 2, z}});
  assembleBoxes(*this, slats_, "bench slats", paint(finish::kOak, 0.15), slats);
  constexpr double kUnder = kHeight - kSlat;
  std::vector<Cuboid> legs;
  for (const double x : {-kWidth / 2 + 0.18, kWidth / 2 - 0.18}) {
    for (const double z : {-0.15, 0.15})
      legs.push_back({{0.05, kUnder - 0.04, 0.03}, {x, (kUnder - 0.04) / 2, z}, kNoBottom | kNoTop});
    legs.push_back({{0.05, 0.04, 0.36}, {x, kUnder - 0.02, 0.0}, kNoTop});
  }
  assembleBoxes(*this, legs_, "bench legs", paint(finish::kSteel, 0.4), legs);
  attach(Solids{{{{0.0, kHeight / 2, 0.0}, {kWidth, kHeight, kDepth}}}});
  attach(finish::wood());
}

Armchair::Armchair(std::uint32_t colour) : VRObject("armchair") {
  seat_.setSize({0.58, 0.22, 0.66}, Pad::Thick::Y);
  assemblePad(*this, seat_, "armchair seat", colour, {0.0, 0.29, 0.02});
  back_.setSize({0.56, 0.60, 0.14}, Pad::Thick::Z);
  assemblePad(*this, back_, "armchair back", colour, {0.0, 0.56, -0.29}, -0.14);
  for (Pad* arm : {&left_arm_, &right_arm_}) {
    arm->setSize({0.11, 0.36, 0.72}, Pad::Thick::X);
    assemblePad(*this, *arm, "armchair arm", colour, {arm == &left_arm_ ? -0.345 : 0.345, 0.37, 0.0});
  }
  std::vector<Cuboid> feet;
  for (const double x : {-0.33, 0.33})
    for (const double z : {-0.28, 0.28}) feet.push_back({{0.05, 0.19, 0.05}, {x, 0.095, z}, kNoBottom});
  assembleBoxes(*this, feet_, "armchair feet", paint(finish::kWalnut, 0.2), feet);
  attach(Solids{{{{0.0, 0.20, 0.0}, {0.80, 0.40, 0.72}},
                 {{0.0, 0.62, -0.30}, {0.60, 0.44, 0.16}},
                 {{-0.345, 0.275, 0.0}, {0.11, 0.55, 0.72}},
                 {{0.345, 0.275, 0.0}, {0.11, 0.55, 0.72}}}});
}

}  // namespace coherency
