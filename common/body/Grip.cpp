#include "common/body/Grip.h"

#include <algorithm>
#include <cmath>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr std::array<double, 3> kOpen = {0.20, 0.26, 0.16};  // curl of the index finger
constexpr std::array<double, 3> kFist = {1.25, 1.62, 0.90};
constexpr double kHoldingKnuckle = 0.62;  // curl of every knuckle round the cube
constexpr double kTip = 0.8;              // fingertips are that much thinner than roots
constexpr double kHoldingSpread = 1.25;   // of the open spread: outer fingers keep to the cube's sides

constexpr ThumbBend kThumbOpen = {0.30, 0.62, 0.05, -0.15};
constexpr ThumbBend kThumbHolding = {1.44, -0.57, 0.0, 0.0};
constexpr ThumbBend kThumbFist = {0.95, -0.35, 0.25, -0.75};

/// Through the three postures: open at 0, holding at kHoldingGrip, a fist at 1.
double through(double open, double holding, double fist, double grip) {
  const double g = std::clamp(grip, 0.0, 1.0);
  if (g < kHoldingGrip) return open + (holding - open) * (g / kHoldingGrip);
  return holding + (fist - holding) * ((g - kHoldingGrip) / (1.0 - kHoldingGrip));
}

/// Bend of the middle joint that brings the finger's tip onto the cube's far face.
double middleAroundCube(const FingerShape& finger) {
  const double face = kUnitHand + kHeldEdge / 2 + kTip * finger.radius;
  const double joint = finger.knuckle.x + finger.length[0] * std::cos(kHoldingKnuckle);
  const double below = finger.length[1] + finger.length[2];
  return kTurn / 4 - kHoldingKnuckle + std::asin(std::clamp((joint - face) / below, -0.5, 0.5));
}

}  // namespace

FingerBend fingerBend(const FingerShape& finger, double grip) {
  const std::array<double, 3> holding = {kHoldingKnuckle, middleAroundCube(finger), 0.0};
  FingerBend bend{through(finger.spread, kHoldingSpread * finger.spread, 0.0, grip), {}};
  for (std::size_t i = 0; i < 3; ++i)
    bend.curl[i] = through(kOpen[i] * finger.rest, holding[i], kFist[i], grip);
  return bend;
}

ThumbBend thumbBend(double grip) {
  const auto of = [grip](double ThumbBend::*angle) {
    return through(kThumbOpen.*angle, kThumbHolding.*angle, kThumbFist.*angle, grip);
  };
  return {of(&ThumbBend::down), of(&ThumbBend::across), of(&ThumbBend::tip_down), of(&ThumbBend::tip_across)};
}

void bendFinger(const FingerBend& bend, double side, const std::array<VRObject*, 3>& segments) {
  for (std::size_t i = 0; i < 3; ++i) segments[i]->setOrientation(TransformMatrix::rotationZ(-bend.curl[i]));
  segments[0]->setOrientation(TransformMatrix::rotationY(-side * bend.spread) * segments[0]->orientation());
}

void bendThumb(const ThumbBend& bend, double side, VRObject& proximal, VRObject& distal) {
  proximal.setOrientation(TransformMatrix::rotationZ(-bend.down) *
                          TransformMatrix::rotationY(side * bend.across));
  distal.setOrientation(TransformMatrix::rotationZ(-bend.tip_down) *
                        TransformMatrix::rotationY(side * bend.tip_across));
}

}  // namespace coherency
