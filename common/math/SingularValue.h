#pragma once

#include <glm/mat3x3.hpp>

namespace coherency {

/// Upper bound, rounded outward, of the largest singular value of `a`: no vector grows by more under it. At
/// most 1e-11 of its value above it; infinity where an element is not finite. Jacobi's rotations bring
/// transpose(a) * a near to diagonal form, and Gershgorin's theorem bounds its eigenvalues (Golub and Van
/// Loan, Matrix Computations, sections 8.5 and 7.2).
double singularValueBound(const glm::dmat3& a);

}  // namespace coherency
