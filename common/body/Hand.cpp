#include "common/body/Hand.h"

#include "common/body/Assemble.h"
#include "common/body/Grip.h"
#include "common/body/Palette.h"

namespace coherency {

namespace {

constexpr std::array<FingerShape, 4> kFingers = {{
    {"index finger", {0.093, 0.001, -0.0315}, -0.09, 1.00, {0.042, 0.025, 0.020}, 0.0093},
    {"middle finger", {0.098, 0.002, -0.0105}, -0.02, 1.12, {0.046, 0.029, 0.021}, 0.0096},
    {"ring finger", {0.095, 0.001, 0.0105}, 0.05, 1.24, {0.042, 0.027, 0.021}, 0.0091},
    {"little finger", {0.087, -0.001, 0.0305}, 0.13, 1.36, {0.034, 0.020, 0.018}, 0.0079},
}};

constexpr double kThumbLength[2] = {0.040, 0.029};
constexpr double kThumbRadius = 0.0108;
constexpr Coord3 kThumbRoot{0.046, -0.011, -0.036};

/// Round at the tip; at the root only where no segment before it fills the joint.
void buildSegment(Loft& segment, double length, double radius, double tip_radius, bool round_root) {
  const Loft::Form form{Loft::Along::X, 10, 2.0, round_root ? radius : 0.0, tip_radius};
  segment.setSections({{0.0, radius, radius},
                       {0.5 * length, 0.93 * (radius + tip_radius) / 2, 0.95 * (radius + tip_radius) / 2},
                       {length, tip_radius, tip_radius}},
                      form);
}

}  // namespace

Hand::Hand(Side side, double wrist_to_palm, std::string name)
    : VRObject(std::move(name)), side_(side == Side::Right ? 1.0 : -1.0), scale_(wrist_to_palm / kUnitHand) {
  buildPalm();
  buildFingers();
  buildThumb();
  setGrip(0.0);
}

void Hand::buildPalm() {
  std::vector<Loft::Section> sections = {{-0.010, 0.0205, 0.0265},
                                         {0.012, 0.0200, 0.0275},
                                         {0.035, 0.0185, 0.0350, -0.002},
                                         {0.065, 0.0160, 0.0405, -0.001},
                                         {0.088, 0.0130, 0.0405}};
  for (auto& s : sections) s = {s.at * scale_, s.a * scale_, s.b * scale_, s.centre_a * scale_, 0.0};
  const Loft::Form form{Loft::Along::X, 14, 2.5, 0.015 * scale_, 0.012 * scale_};
  palm_.setSections(sections, form);
  assemble(*this, palm_, name() + " palm", paint(palette::kSkin));

  const double s = scale_;
  heel_.setSections({{-0.012 * s, 0.013 * s, 0.014 * s}, {0.014 * s, 0.0125 * s, 0.0125 * s}},
                    {Loft::Along::X, 10, 2.0, 0.014 * s, 0.013 * s});
  assemble(*this, heel_, name() + " thumb heel", paint(palette::kSkin),
           {0.032 * s, -0.008 * s, -0.026 * s * side_});
  heel_.setOrientation(TransformMatrix::rotationY(0.5 * side_));
}

void Hand::buildFingers() {
  static constexpr const char* kParts[3] = {" proximal", " middle", " distal"};
  for (std::size_t f = 0; f < fingers_.size(); ++f) {
    const FingerShape& shape = kFingers[f];
    const Coord3 knuckle{shape.knuckle.x, shape.knuckle.y, shape.knuckle.z * side_};
    VRObject* root = this;
    for (std::size_t i = 0; i < 3; ++i) {
      const double radius = shape.radius * scale_ * (1.0 - 0.08 * static_cast<double>(i));
      buildSegment(fingers_[f][i], shape.length[i] * scale_, radius, 0.92 * radius, i < 2);
      const Coord3 at = i == 0 ? knuckle * scale_ : Coord3{shape.length[i - 1] * scale_, 0.0, 0.0};
      assemble(*root, fingers_[f][i], name() + ' ' + shape.name + kParts[i], paint(palette::kSkin), at);
      root = &fingers_[f][i];
    }
  }
}

void Hand::buildThumb() {
  const double radius = kThumbRadius * scale_;
  buildSegment(thumb_[0], kThumbLength[0] * scale_, 1.08 * radius, radius, true);
  buildSegment(thumb_[1], kThumbLength[1] * scale_, radius, 0.85 * radius, false);
  const Coord3 root{kThumbRoot.x, kThumbRoot.y, kThumbRoot.z * side_};
  assemble(*this, thumb_[0], name() + " thumb proximal", paint(palette::kSkin), root * scale_);
  assemble(thumb_[0], thumb_[1], name() + " thumb distal", paint(palette::kSkin),
           {kThumbLength[0] * scale_, 0.0, 0.0});
}

void Hand::setGrip(double grip) {
  for (std::size_t f = 0; f < fingers_.size(); ++f)
    bendFinger(fingerBend(kFingers[f], grip), side_, {&fingers_[f][0], &fingers_[f][1], &fingers_[f][2]});
  bendThumb(thumbBend(grip), side_, thumb_[0], thumb_[1]);
}

double Hand::knuckleBend(double grip) {
  return fingerBend(kFingers[1], grip).curl[0];
}

}  // namespace coherency
