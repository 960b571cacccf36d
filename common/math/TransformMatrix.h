#pragma once

#include <glm/mat4x4.hpp>

#include "common/math/Coord3.h"

namespace coherency {

/// 4x4 homogeneous transform (paper, section III.A and III.B). `T_a_b` maps coordinates in frame b to
/// coordinates in frame a, so that inner names meet: T_a_c = T_a_b * T_b_c (eq. 4).
/// Vectors are columns: p_a = T_a_b * p_b (eq. 2).
class TransformMatrix {
 public:
  /// Identity.
  TransformMatrix() : m_(1.0) {}
  explicit TransformMatrix(const glm::dmat4& m) : m_(m) {}

  static TransformMatrix translation(const Coord3& t);
  static TransformMatrix scaling(const Coord3& s);
  /// Right-handed rotations about the coordinate axes; radians.
  static TransformMatrix rotationX(double angle_rad);
  static TransformMatrix rotationY(double angle_rad);
  static TransformMatrix rotationZ(double angle_rad);
  /// Right-handed rotation about `axis`, which need not be of unit length; throws std::domain_error if it is
  /// zero.
  static TransformMatrix rotation(const Coord3& axis, double angle_rad);
  /// Frame whose x, y and z axes and origin are the given columns.
  static TransformMatrix fromAxes(const Coord3& x, const Coord3& y, const Coord3& z,
                                  const Coord3& origin = {});

  /// Element in row 0..3 and column 0..3.
  double operator()(int row, int column) const { return m_[column][row]; }
  double& operator()(int row, int column) { return m_[column][row]; }
  const glm::dmat4& glm() const { return m_; }

  TransformMatrix& operator+=(const TransformMatrix& b);
  TransformMatrix& operator-=(const TransformMatrix& b);
  TransformMatrix& operator*=(double s);
  /// Throws std::domain_error when `s` is zero.
  TransformMatrix& operator/=(double s);
  bool operator==(const TransformMatrix& b) const { return m_ == b.m_; }

  /// Image of a point; w is taken as 1 and the last row is ignored (affine transforms).
  Coord3 point(const Coord3& p) const { return vector(p) + origin(); }
  /// Image of a direction: the translation is ignored.
  Coord3 vector(const Coord3& v) const {
    return {m_[0].x * v.x + m_[1].x * v.y + m_[2].x * v.z, m_[0].y * v.x + m_[1].y * v.y + m_[2].y * v.z,
            m_[0].z * v.x + m_[1].z * v.y + m_[2].z * v.z};
  }
  /// Origin of the mapped frame: the last column.
  Coord3 origin() const { return {m_[3].x, m_[3].y, m_[3].z}; }
  void setOrigin(const Coord3& origin);
  /// The 3x3 part, with no translation.
  TransformMatrix linear() const;

  /// General inverse. Throws std::domain_error naming the condition number when the matrix is singular,
  /// not finite, or conditioned worse than `max_condition`; never returns a NaN. The condition is in the
  /// infinity norm; that of an affine transform is its 3x3 part's, as being far from the origin makes no
  /// frame singular.
  TransformMatrix inverse(double max_condition = 1e12) const;
  /// Inverse of a rotation and a translation; exact transpose, no division. Precondition: isRigid().
  TransformMatrix rigidInverse() const;
  /// True if the 3x3 part is a proper rotation to `tolerance` and the last row is 0 0 0 1.
  bool isRigid(double tolerance = 1e-9) const;
  bool isFinite() const;
  /// Upper bound, rounded outward, of the largest singular value of the 3x3 part (shear included): no vector
  /// grows by more. Used for bounding spheres.
  double maxScale() const;

 private:
  glm::dmat4 m_;
};

TransformMatrix operator+(TransformMatrix a, const TransformMatrix& b);
TransformMatrix operator-(TransformMatrix a, const TransformMatrix& b);
TransformMatrix operator*(const TransformMatrix& a, const TransformMatrix& b);
TransformMatrix operator*(TransformMatrix a, double s);
TransformMatrix operator*(double s, TransformMatrix a);
TransformMatrix operator/(TransformMatrix a, double s);

}  // namespace coherency
