#include "common/math/SingularValue.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace coherency {
namespace {

constexpr int kMaxSweeps = 8;           // four suffice for a 3x3; the bound holds after any number of them
constexpr double kNegligible = 1e-14;   // off the diagonal, relative to the largest element
constexpr double kRoundingOff = 1e-12;  // far above the rounding errors of it all

/// transpose(a) * a.
glm::dmat3 gram(const glm::dmat3& a) {
  glm::dmat3 g;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) g[i][j] = glm::dot(a[i], a[j]);
  return g;
}

/// One Jacobi rotation of a symmetric matrix: makes element (p, q) zero and keeps the eigenvalues (Golub and
/// Van Loan, Matrix Computations, section 8.5).
void jacobiRotate(glm::dmat3& a, int p, int q) {
  if (a[p][q] == 0.0) return;
  const double tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::hypot(1.0, tau));
  const double c = 1.0 / std::hypot(1.0, t);
  const double s = t * c;
  const int r = 3 - p - q;
  const double arp = a[r][p];
  const double arq = a[r][q];
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0.0;
  a[r][p] = a[p][r] = c * arp - s * arq;
  a[r][q] = a[q][r] = s * arp + c * arq;
}

/// No eigenvalue of a symmetric matrix is larger (Gershgorin).
double gershgorinBound(const glm::dmat3& a) {
  double bound = 0.0;
  for (int i = 0; i < 3; ++i)
    bound = std::max(bound, a[i][i] + std::abs(a[i][(i + 1) % 3]) + std::abs(a[i][(i + 2) % 3]));
  return bound;
}

double largestOffDiagonal(const glm::dmat3& a) {
  return std::max({std::abs(a[0][1]), std::abs(a[0][2]), std::abs(a[1][2])});
}

}  // namespace

double singularValueBound(const glm::dmat3& a) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      if (!std::isfinite(a[column][row])) return kInfinity;
      largest = std::max(largest, std::abs(a[column][row]));
    }
  if (largest == 0.0) return 0.0;

  glm::dmat3 g(a);  // in units of its largest element, whose square might overflow
  for (int column = 0; column < 3; ++column) g[column] /= largest;
  g = gram(g);
  for (int sweep = 0; sweep < kMaxSweeps && largestOffDiagonal(g) > kNegligible; ++sweep) {
    jacobiRotate(g, 0, 1);
    jacobiRotate(g, 0, 2);
    jacobiRotate(g, 1, 2);
  }
  return std::nextafter(largest * std::sqrt(gershgorinBound(g)) * (1.0 + kRoundingOff), kInfinity);
}

}  // namespace coherency
