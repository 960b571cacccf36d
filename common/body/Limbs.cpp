#include "common/body/Limbs.h"

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/body/Posture.h"

namespace coherency {

namespace {

constexpr double kElbowRadius = 0.045;
constexpr double kKneeRadius = 0.062;

}  // namespace

ArmShape::ArmShape(const Rig& rig, Hand::Side side, const std::string& name)
    : VRObject(name), hand_(side, rig.hand, name + " hand") {
  const double upper = rig.upper_arm;
  upper_.setSections({{0.0, 0.057, 0.057},
                      {0.16 * upper, 0.061, 0.061},
                      {0.55 * upper, 0.056, 0.056},
                      {upper, kElbowRadius + 0.003, kElbowRadius + 0.003}},
                     {Loft::Along::X, 14, 2.0, 0.046, kElbowRadius + 0.003});
  assemble(*this, upper_, name + " upper arm", paint(palette::kShirt));
  const double fore = rig.forearm;
  forearm_.setSections({{0.0, kElbowRadius, kElbowRadius},
                        {0.22 * fore, 0.0450, 0.0455},
                        {0.60 * fore, 0.0345, 0.0365},
                        {0.90 * fore, 0.0255, 0.0295},
                        {fore, 0.0225, 0.0280}},
                       {Loft::Along::X, 14, 2.0, kElbowRadius, 0.018});
  assemble(*this, forearm_, name + " forearm", paint(palette::kSkin));
  // Round the elbow too, so that a bent arm's sleeve does not part there.
  sleeve_.setSections({{0.0, 0.0485, 0.0485}, {0.12 * fore, 0.0515, 0.0515}, {0.27 * fore, 0.0500, 0.0505}},
                      {Loft::Along::X, 14, 2.0, 0.0485, 0.0});
  assemble(forearm_, sleeve_, name + " sleeve", paint(palette::kShirt));
  cuff_.setSections({{0.25 * fore, 0.0520, 0.0525}, {0.31 * fore, 0.0515, 0.0520}},
                    {Loft::Along::X, 14, 2.0, 0.0, 0.0});
  assemble(forearm_, cuff_, name + " cuff", paint(palette::kShirtTrim));
  addMember(&hand_);
}

void ArmShape::setPose(const TransformMatrix& t_body_upper, const TransformMatrix& t_body_forearm,
                       const TransformMatrix& t_body_hand) {
  upper_.setTransform(t_body_upper);
  forearm_.setTransform(t_body_forearm);
  hand_.setTransform(t_body_hand);
}

LegShape::LegShape(const Rig& rig, const std::string& name) : VRObject(name), foot_(name + " foot") {
  thigh_.setSections({{0.0, 0.084, 0.082},
                      {0.30 * rig.thigh, 0.083, 0.081},
                      {0.75 * rig.thigh, 0.069, 0.068},
                      {rig.thigh, kKneeRadius, kKneeRadius}},
                     {Loft::Along::X, 16, 2.1, 0.07, kKneeRadius});
  assemble(*this, thigh_, name + " thigh", paint(palette::kTrousers));
  shin_.setSections({{0.0, kKneeRadius - 0.002, kKneeRadius - 0.002},
                     {0.30 * rig.shin, 0.060, 0.060},
                     {0.75 * rig.shin, 0.053, 0.053},
                     {0.97 * rig.shin, 0.051, 0.052}},
                    {Loft::Along::X, 16, 2.0, kKneeRadius - 0.002, 0.0});
  assemble(*this, shin_, name + " shin", paint(palette::kTrousers));
  addMember(&foot_);
  buildShoe(rig);
}

double LegShape::ankleHeight(const Rig& rig) {
  return 0.34 * rig.foot;
}

/// Sizes for a foot of 0.25 m, heel 0.06 m behind the ankle.
void LegShape::buildShoe(const Rig& rig) {
  const double k = rig.foot / 0.25;
  const double floor = -ankleHeight(rig);
  // Along z from the toes back; each section's bottom stands on the sole.
  std::vector<Loft::Section> sections = {{-0.172, 0.034, 0.017}, {-0.135, 0.045, 0.026},
                                         {-0.085, 0.046, 0.035}, {-0.035, 0.040, 0.045},
                                         {0.015, 0.037, 0.048},  {0.042, 0.034, 0.046}};
  for (auto& s : sections) s = {s.at * k, s.a * k, s.b * k, 0.0, floor + (0.013 + s.b) * k};
  shoe_.setSections(sections, {Loft::Along::Z, 14, 2.6, 0.016 * k, 0.016 * k});
  assemble(foot_, shoe_, name() + " shoe", paint(palette::kShoe, 0.25));
  const double half_length = 0.127 * k;
  sole_.setSections(
      {{floor, half_length, 0.045 * k, -0.065 * k}, {floor + 0.017 * k, half_length, 0.047 * k, -0.065 * k}},
      {Loft::Along::Y, 18, 2.6, 0.0, 0.0});
  assemble(foot_, sole_, name() + " sole", paint(palette::kSole));
}

void LegShape::setPose(const Coord3& hip, const Coord3& knee, const TransformMatrix& t_body_foot) {
  const Coord3 side{1.0, 0.0, 0.0};
  thigh_.setTransform(frameAlong(hip, knee, side));
  shin_.setTransform(frameAlong(knee, t_body_foot.origin(), side));
  foot_.setTransform(t_body_foot);
}

}  // namespace coherency
