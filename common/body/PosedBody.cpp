#include "common/body/PosedBody.h"

#include <utility>

#include "common/scene/Light.h"

namespace coherency {

PosedBody::PosedBody(std::string name, const Rig& rig) : VRObject(std::move(name)), rig_(rig), arm_(rig) {
  attach(Moving{});
  addMember(&head_);
  addMember(&right_hand_);
  for (const int side : {-1, 1, 0}) {
    const Eye which = side < 0 ? Eye::Left : side > 0 ? Eye::Right : Eye::Mono;
    ViewPoint& eye = eyes_[static_cast<std::size_t>(which)];
    eye.setTransform(headToEye(rig, side));
    eye.attachTo(&head_);
  }
  takeUp(neutralSample(rig));
}

void PosedBody::takeUp(const MotionSample& sample) {
  posture_ = coherency::posture(rig_, arm_, sample);
  head_.setTransform(posture_.t_body_head);
  right_hand_.setTransform(posture_.t_body_shoulder * posture_.right_arm.t_shoulder_hand);
}

}  // namespace coherency
