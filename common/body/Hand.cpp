#include "common/body/Hand.h"

#include <algorithm>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"

namespace coherency {

namespace {

constexpr double kUnitHand = 0.09;  // m, wrist to palm, of the sizes below

struct FingerShape {
  const char* name;
  Coord3 knuckle;  // right hand
  double spread;   // rad towards the little finger's side, open
  double length[3];
  double radius;
};
constexpr FingerShape kFingers[4] = {
    {"index finger", {0.093, 0.001, -0.0315}, -0.09, {0.042, 0.025, 0.020}, 0.0093},
    {"middle finger", {0.098, 0.002, -0.0105}, -0.02, {0.046, 0.029, 0.021}, 0.0096},
    {"ring finger", {0.095, 0.001, 0.0105}, 0.05, {0.042, 0.027, 0.021}, 0.0091},
    {"little finger", {0.087, -0.001, 0.0305}, 0.13, {0.034, 0.020, 0.018}, 0.0079},
};
constexpr double kCurlOpen[3] = {0.20, 0.26, 0.16};    // rad, a joint
constexpr double kCurlClosed[3] = {1.25, 1.62, 0.90};  // a fist

constexpr double kThumbLength[2] = {0.040, 0.029};
constexpr double kThumbRadius = 0.0108;
constexpr Coord3 kThumbRoot{0.046, -0.011, -0.036};

double between(double open, double closed, double grip) {
  return open + (closed - open) * grip;
}

void buildSegment(Loft& segment, double length, double radius, double tip_radius) {
  const Loft::Form form{Loft::Along::X, 10, 2.0, radius, tip_radius};
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
      buildSegment(fingers_[f][i], shape.length[i] * scale_, radius, 0.92 * radius);
      const Coord3 at = i == 0 ? knuckle * scale_ : Coord3{shape.length[i - 1] * scale_, 0.0, 0.0};
      assemble(*root, fingers_[f][i], name() + ' ' + shape.name + kParts[i], paint(palette::kSkin), at);
      root = &fingers_[f][i];
    }
  }
}

void Hand::buildThumb() {
  const double radius = kThumbRadius * scale_;
  buildSegment(thumb_[0], kThumbLength[0] * scale_, 1.08 * radius, radius);
  buildSegment(thumb_[1], kThumbLength[1] * scale_, radius, 0.85 * radius);
  const Coord3 root{kThumbRoot.x, kThumbRoot.y, kThumbRoot.z * side_};
  assemble(*this, thumb_[0], name() + " thumb proximal", paint(palette::kSkin), root * scale_);
  assemble(thumb_[0], thumb_[1], name() + " thumb distal", paint(palette::kSkin),
           {kThumbLength[0] * scale_, 0.0, 0.0});
}

void Hand::setGrip(double grip) {
  const double g = std::clamp(grip, 0.0, 1.0);
  for (std::size_t f = 0; f < fingers_.size(); ++f) {
    const double spread = -side_ * kFingers[f].spread * (1.0 - g);
    for (std::size_t i = 0; i < 3; ++i) {
      const double more = 1.0 + 0.12 * static_cast<double>(f);  // the little finger's side rests more curled
      const double curl = between(kCurlOpen[i] * more, kCurlClosed[i], g);
      const TransformMatrix bend = TransformMatrix::rotationZ(-curl);
      fingers_[f][i].setOrientation(i == 0 ? TransformMatrix::rotationY(spread) * bend : bend);
    }
  }
  thumb_[0].setOrientation(TransformMatrix::rotationZ(-between(0.30, 0.95, g)) *
                           TransformMatrix::rotationY(side_ * between(0.62, -0.35, g)));
  thumb_[1].setOrientation(TransformMatrix::rotationZ(-between(0.05, 0.25, g)) *
                           TransformMatrix::rotationY(-side_ * between(0.15, 0.75, g)));
}

}  // namespace coherency
