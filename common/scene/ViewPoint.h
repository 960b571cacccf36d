#pragma once

#include "common/scene/VRFrame.h"
#include "common/scene/VRObject.h"

namespace coherency {

/// Where an eye is (paper, section III.A.3 and III.B): a frame carried by an object, -z ahead, y up.
class ViewPoint : public VRFrame {
 public:
  /// Carried by `carrier`, which must outlive it; null stands for the world itself.
  void attachTo(const VRObject* carrier) { carrier_ = carrier; }
  const VRObject* carrier() const { return carrier_; }

  /// T_world_eye = T_world_body * T_body_head * T_head_eye (eq. 5).
  TransformMatrix globalTransform() const;
  /// T_eye_object = inverse(T_world_eye) * T_world_object (eq. 7). Throws std::domain_error where the eye's
  /// transform cannot be inverted.
  TransformMatrix viewing(const TransformMatrix& t_world_object) const;

 private:
  const VRObject* carrier_ = nullptr;
};

}  // namespace coherency
