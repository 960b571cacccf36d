#include "common/scene/VRFrame.h"

#include <stdexcept>

namespace coherency {

void VRFrame::setTransform(const TransformMatrix& t_parent_this) {
  if (!t_parent_this.isFinite())
    throw std::domain_error("VRFrame: transform refused, it has an element that is not finite");
  assign(t_parent_this);
}

void VRFrame::setPosition(const Coord3& position) {
  if (!isFinite(position))
    throw std::domain_error("VRFrame: position refused, it has a coordinate that is not finite");
  TransformMatrix t = transform_;
  t.setOrigin(position);
  assign(t);
}

void VRFrame::setOrientation(const TransformMatrix& linear) {
  TransformMatrix t = linear.linear();
  t.setOrigin(position());
  setTransform(t);
}

}  // namespace coherency
