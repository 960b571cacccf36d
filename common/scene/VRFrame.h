#pragma once

#include "common/math/Rotation.h"
#include "common/math/TransformMatrix.h"

namespace coherency {

/// A frame with one transform matrix: where something stands and which way it faces, relative to whatever it
/// belongs to (paper, section III.B). Metres, radians. Setters refuse non-finite values with
/// std::domain_error.
class VRFrame {
 public:
  VRFrame() = default;
  virtual ~VRFrame() = default;

  /// T_parent_this.
  const TransformMatrix& transform() const { return transform_; }
  void setTransform(const TransformMatrix& t_parent_this);

  Coord3 position() const { return transform_.origin(); }
  void setPosition(const Coord3& position);
  void setPosition(double x, double y, double z) { setPosition(Coord3{x, y, z}); }

  /// The 3x3 part, scale and shear included.
  TransformMatrix orientation() const { return transform_.linear(); }
  /// Replaces the 3x3 part (a scale that was there is lost) and keeps the position.
  void setOrientation(const TransformMatrix& linear);
  void setOrientation(const YawPitchRoll& angles) { setOrientation(rotation(angles)); }

  /// Moves along the parent's axes.
  void translate(const Coord3& by) { setPosition(position() + by); }
  /// Turns or scales in this frame's own axes: orientation becomes orientation * linear.
  void rotate(const TransformMatrix& linear) { setOrientation(orientation() * linear.linear()); }
  void scale(const Coord3& by) { rotate(TransformMatrix::scaling(by)); }

 protected:
  VRFrame(const VRFrame&) = default;
  VRFrame& operator=(const VRFrame&) = default;

  /// Through here goes every setter, with a transform that is finite.
  virtual void assign(const TransformMatrix& t_parent_this) { transform_ = t_parent_this; }

 private:
  TransformMatrix transform_;
};

}  // namespace coherency
