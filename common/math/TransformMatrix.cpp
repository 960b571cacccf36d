#include "common/math/TransformMatrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/math/SingularValue.h"
#include "common/math/Trigonometry.h"

namespace coherency {
namespace {

bool isAffine(const TransformMatrix& m) {
  return m(3, 0) == 0.0 && m(3, 1) == 0.0 && m(3, 2) == 0.0 && m(3, 3) == 1.0;
}

/// Largest sum of magnitudes in a row of the leading size x size part.
double infinityNorm(const TransformMatrix& m, int size) {
  double largest = 0.0;
  for (int row = 0; row < size; ++row) {
    double sum = 0.0;
    for (int column = 0; column < size; ++column) sum += std::abs(m(row, column));
    largest = std::max(largest, sum);
  }
  return largest;
}

void swapRows(TransformMatrix& m, int a, int b) {
  for (int column = 0; column < 4; ++column) std::swap(m(a, column), m(b, column));
}

void addRow(TransformMatrix& m, int to, int from, double factor) {
  for (int column = 0; column < 4; ++column) m(to, column) += factor * m(from, column);
}

/// Gauss-Jordan elimination with partial pivoting; false where a pivot is zero.
bool eliminate(TransformMatrix left, TransformMatrix& right) {
  for (int column = 0; column < 4; ++column) {
    int pivot = column;
    for (int row = column + 1; row < 4; ++row)
      if (std::abs(left(row, column)) > std::abs(left(pivot, column))) pivot = row;
    if (left(pivot, column) == 0.0) return false;
    swapRows(left, pivot, column);
    swapRows(right, pivot, column);
    const double divisor = left(column, column);
    for (int k = 0; k < 4; ++k) {
      left(column, k) /= divisor;
      right(column, k) /= divisor;
    }
    for (int row = 0; row < 4; ++row) {
      if (row == column) continue;
      const double factor = -left(row, column);
      addRow(left, row, column, factor);
      addRow(right, row, column, factor);
    }
  }
  return true;
}

}  // namespace

TransformMatrix TransformMatrix::translation(const Coord3& t) {
  TransformMatrix m;
  m.setOrigin(t);
  return m;
}

TransformMatrix TransformMatrix::scaling(const Coord3& s) {
  return fromAxes({s.x, 0.0, 0.0}, {0.0, s.y, 0.0}, {0.0, 0.0, s.z});
}

TransformMatrix TransformMatrix::rotationX(double angle_rad) {
  const auto [s, c] = sineCosine(angle_rad);
  return fromAxes({1.0, 0.0, 0.0}, {0.0, c, s}, {0.0, -s, c});
}

TransformMatrix TransformMatrix::rotationY(double angle_rad) {
  const auto [s, c] = sineCosine(angle_rad);
  return fromAxes({c, 0.0, -s}, {0.0, 1.0, 0.0}, {s, 0.0, c});
}

TransformMatrix TransformMatrix::rotationZ(double angle_rad) {
  const auto [s, c] = sineCosine(angle_rad);
  return fromAxes({c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0});
}

TransformMatrix TransformMatrix::rotation(const Coord3& axis, double angle_rad) {
  const Coord3 n = normalized(axis);
  const double half_sine = sineCosine(0.5 * angle_rad).sine;
  const double s = sineCosine(angle_rad).sine;
  const double v = 2.0 * half_sine * half_sine;  // 1 - cos, without its cancellation at small angles
  const auto column = [&](const Coord3& e) { return e + s * cross(n, e) + v * cross(n, cross(n, e)); };
  return fromAxes(column({1.0, 0.0, 0.0}), column({0.0, 1.0, 0.0}), column({0.0, 0.0, 1.0}));
}

TransformMatrix TransformMatrix::fromAxes(const Coord3& x, const Coord3& y, const Coord3& z,
                                          const Coord3& origin) {
  return TransformMatrix(glm::dmat4(glm::dvec4(x.glm(), 0.0), glm::dvec4(y.glm(), 0.0),
                                    glm::dvec4(z.glm(), 0.0), glm::dvec4(origin.glm(), 1.0)));
}

TransformMatrix& TransformMatrix::operator+=(const TransformMatrix& b) {
  m_ += b.m_;
  return *this;
}

TransformMatrix& TransformMatrix::operator-=(const TransformMatrix& b) {
  m_ -= b.m_;
  return *this;
}

TransformMatrix& TransformMatrix::operator*=(double s) {
  m_ *= s;
  return *this;
}

TransformMatrix& TransformMatrix::operator/=(double s) {
  if (s == 0.0) throw std::domain_error("TransformMatrix: division by zero");
  m_ /= s;
  return *this;
}

void TransformMatrix::setOrigin(const Coord3& origin) {
  m_[3].x = origin.x;
  m_[3].y = origin.y;
  m_[3].z = origin.z;
}

TransformMatrix TransformMatrix::linear() const {
  glm::dmat4 m(m_);
  m[0].w = m[1].w = m[2].w = 0.0;
  m[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
  return TransformMatrix(m);
}

TransformMatrix TransformMatrix::inverse(double max_condition) const {
  if (!isFinite())
    throw std::domain_error("TransformMatrix::inverse: the matrix has an element that is not finite");
  TransformMatrix result;
  double condition = std::numeric_limits<double>::infinity();
  if (eliminate(*this, result) && result.isFinite()) {
    const int size = isAffine(*this) ? 3 : 4;
    condition = infinityNorm(*this, size) * infinityNorm(result, size);
  }
  if (!std::isfinite(condition) || condition > max_condition) {
    std::ostringstream text;
    text << "TransformMatrix::inverse: condition number " << condition << " exceeds " << max_condition
         << "; the matrix is singular or nearly so";
    throw std::domain_error(text.str());
  }
  return result;
}

TransformMatrix TransformMatrix::rigidInverse() const {
  assert(isRigid(1e-6));
  const Coord3 t = origin();
  TransformMatrix r;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) r(row, column) = (*this)(column, row);
  r.setOrigin(-r.vector(t));
  return r;
}

bool TransformMatrix::isRigid(double tolerance) const {
  if (!isFinite() || !isAffine(*this)) return false;
  const Coord3 axes[3] = {vector({1.0, 0.0, 0.0}), vector({0.0, 1.0, 0.0}), vector({0.0, 0.0, 1.0})};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      if (!(std::abs(dot(axes[i], axes[j]) - (i == j ? 1.0 : 0.0)) <= tolerance)) return false;
  return dot(cross(axes[0], axes[1]), axes[2]) > 0.0;
}

bool TransformMatrix::isFinite() const {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(m_[column][row])) return false;
  return true;
}

double TransformMatrix::maxScale() const {
  return singularValueBound(glm::dmat3(m_));
}

TransformMatrix operator+(TransformMatrix a, const TransformMatrix& b) {
  return a += b;
}
TransformMatrix operator-(TransformMatrix a, const TransformMatrix& b) {
  return a -= b;
}
TransformMatrix operator*(const TransformMatrix& a, const TransformMatrix& b) {
  return TransformMatrix(a.glm() * b.glm());
}
TransformMatrix operator*(TransformMatrix a, double s) {
  return a *= s;
}
TransformMatrix operator*(double s, TransformMatrix a) {
  return a *= s;
}
TransformMatrix operator/(TransformMatrix a, double s) {
  return a /= s;
}

}  // namespace coherency
