#include "common/body/robot/RobotHead.h"

#include "common/body/Assemble.h"
#include "common/body/robot/RobotSize.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

using enum Loft::Along;

std::vector<Loft::Section> scaled(std::vector<Loft::Section> sections, double k, double centre_b = 0.0) {
  for (auto& s : sections) s = {s.at * k, s.a * k, s.b * k, s.centre_a * k, s.centre_b * k + centre_b};
  return sections;
}

}  // namespace

RobotHead::RobotHead(const Rig& rig) : VRObject("robot head") {
  for (VRObject* frame : {&pan_, &tilt_, &head_}) addMember(frame);
  buildNeck(rig);
  buildSkull(rig);
  buildCameras(rig);
}

/// All three axes meet at the neck's base, the origin of pan_ and tilt_.
void RobotHead::buildNeck(const Rig& rig) {
  const double k = RobotSize(rig).trunk;
  pan_drum_.setProfile(Y, 12, {{-0.050 * k, 0.056 * k}, {-0.030 * k, 0.050 * k}}, Ends::Last);
  assemble(pan_, pan_drum_, "robot pan drum", robot_paint::joint());
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = i == 0 ? -1.0 : 1.0;
    cheeks_[i].setSections(Y, 0.0,
                           {{-0.031 * k, 0.028 * k, 0.006 * k, 0.0, side * 0.040 * k},
                            {0.022 * k, 0.016 * k, 0.006 * k, 0.0, side * 0.040 * k}},
                           Ends::Last);
    assemble(pan_, cheeks_[i], "robot neck cheek", robot_paint::hull());
  }
  tilt_drum_.setProfile(X, 8, {{-0.050 * k, 0.018 * k}, {0.050 * k, 0.018 * k}}, Ends::Both);
  assemble(tilt_, tilt_drum_, "robot tilt drum", robot_paint::metal());
  roll_drum_.setProfile(Z, 8, {{-0.034 * k, 0.026 * k}, {0.034 * k, 0.026 * k}}, Ends::Both);
  assemble(tilt_, roll_drum_, "robot roll drum", robot_paint::joint());
  const double top = std::max(rig.neck_length - 0.04 * k, 0.03 * k);
  post_.setProfile(Y, 8, {{0.0, 0.024 * k}, {top, 0.030 * k}}, Ends::Open);
  assemble(head_, post_, "robot neck post", robot_paint::metal(), {0.0, -rig.neck_length, rig.neck_back});
}

void RobotHead::buildSkull(const Rig& rig) {
  const double k = RobotSize(rig).head;
  // Stays behind the plane of the eyes, so that it cannot come into their view.
  skull_.setSections(Y, 0.40,
                     scaled({{-0.060, 0.052, 0.050, 0.024},
                             {-0.020, 0.076, 0.073, 0.022},
                             {0.060, 0.080, 0.076, 0.024},
                             {0.100, 0.054, 0.052, 0.026}},
                            k),
                     Ends::Both);
  assemble(head_, skull_, "robot skull", robot_paint::hull());
  // From ear to ear over the skull's flat top: what the head is lifted by.
  handle_.setForm(Z, {0.044 * k, 0.052 * k, 0.009 * k, 0.08 * kTurn, 0.42 * kTurn, 2}, Ends::Open);
  assemble(head_, handle_, "robot head handle", robot_paint::accent(), {0.0, 0.070 * k, 0.026 * k});
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<Turned::Ring> out = {
        {0.070 * k, 0.036 * k}, {0.088 * k, 0.034 * k}, {0.096 * k, 0.022 * k}};
    const std::vector<Turned::Ring> left = {
        {-0.096 * k, 0.022 * k}, {-0.088 * k, 0.034 * k}, {-0.070 * k, 0.036 * k}};
    ears_[i].setProfile(X, 8, i == 0 ? left : out, i == 0 ? Ends::First : Ends::Last);
    assemble(head_, ears_[i], "robot ear", robot_paint::joint(), {0.0, 0.010 * k, 0.024 * k});
  }
  aerial_.setSections(Y, 0.0, scaled({{0.080, 0.004, 0.004}, {0.190, 0.002, 0.002}}, k), Ends::Last);
  assemble(head_, aerial_, "robot aerial", robot_paint::joint(), {0.052 * k, 0.0, 0.060 * k});
}

void RobotHead::buildCameras(const Rig& rig) {
  const double k = RobotSize(rig).head;
  housing_.setSections(
      Z, 0.35,
      scaled({{-0.124, 0.068, 0.034}, {-0.106, 0.076, 0.042}, {-0.030, 0.074, 0.044}}, k, rig.eye_up),
      Ends::First);
  assemble(head_, housing_, "robot camera housing", robot_paint::joint());
  const double wide = 0.42 * rig.eye_distance;
  for (std::size_t i = 0; i < 2; ++i) {
    const Coord3 eye = headToEye(rig, i == 0 ? -1 : 1).origin();
    const Coord3 front{eye.x, eye.y, -0.124 * k};
    // Opens by 45 degrees, so that the other eye lies in the same cone.
    hoods_[i].setProfile(Z, 12, {{-0.010 * k, wide - 0.010 * k}, {0.0, wide}}, Ends::Open);
    assemble(head_, hoods_[i], "robot lens hood", robot_paint::metal(), front);
    lenses_[i].setShape(firstRing(hoods_[i], 12));
    assemble(head_, lenses_[i], "robot lens", robot_paint::lens(), front);
  }
}

void RobotHead::setPosture(const Posture& posture) {
  const TransformMatrix& thorax = posture.t_body_thorax;
  const YawPitchRoll turn = yawPitchRoll(thorax.linear().rigidInverse() * posture.t_body_head.linear());
  pan_.setTransform(thorax * TransformMatrix::rotationY(turn.yaw));
  tilt_.setTransform(pan_.transform() * TransformMatrix::rotationX(turn.pitch));
  head_.setTransform(posture.t_body_head);
}

}  // namespace coherency
