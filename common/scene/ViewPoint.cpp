#include "common/scene/ViewPoint.h"

namespace coherency {

TransformMatrix ViewPoint::globalTransform() const {
  return carrier_ == nullptr ? transform() : carrier_->globalTransform() * transform();
}

TransformMatrix ViewPoint::viewing(const TransformMatrix& t_world_object) const {
  const TransformMatrix t_world_eye = globalTransform();
  const TransformMatrix t_eye_world =
      t_world_eye.isRigid() ? t_world_eye.rigidInverse() : t_world_eye.inverse();
  return t_eye_world * t_world_object;
}

}  // namespace coherency
