#include "common/body/master/MasterSystem.h"

#include "common/body/Hand.h"

namespace coherency {

MasterSystem::MasterSystem(const Rig& rig)
    : VRObject("master system"),
      layout_(rig),
      seat_(layout_),
      pedal_left_("left pedal", rig.foot, layout_.pedal_left.y - layout_.deck_top),
      pedal_right_("right pedal", rig.foot, layout_.pedal_right.y - layout_.deck_top),
      head_link_(rig, layout_),
      exoskeleton_(rig, layout_) {
  joystick_.setPosition(layout_.joystick);
  pedal_left_.setPosition(layout_.pedal_left);
  pedal_right_.setPosition(layout_.pedal_right);
  for (VRObject* part : std::initializer_list<VRObject*>{&seat_, &joystick_, &pedal_left_, &pedal_right_,
                                                         &head_link_, &exoskeleton_})
    addMember(part);
}

void MasterSystem::setSample(const Posture& posture, const MotionSample& sample) {
  joystick_.set(sample.si(Dof::StickX), sample.si(Dof::StickY), sample.si(Dof::StickTwist));
  pedal_left_.set(sample.si(Dof::PedalLeft));
  pedal_right_.set(sample.si(Dof::PedalRight));
  seat_.setPosture(posture);
  head_link_.setPosture(posture);
  exoskeleton_.setPosture(posture, Hand::knuckleBend(sample.si(Dof::Grip)));
}

TransformMatrix MasterSystem::handle() const {
  return joystick_.transform() * joystick_.handle().parent()->transform() * joystick_.handle().transform();
}

}  // namespace coherency
