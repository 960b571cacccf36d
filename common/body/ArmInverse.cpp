// The inverse of ArmKinematics::pose().

#include <algorithm>
#include <cmath>

#include "common/body/ArmKinematics.h"
#include "common/math/Rotation.h"

namespace coherency {

namespace {

constexpr double kAngleWeight = 0.05;  // m that a radian of the hand's attitude counts for
constexpr int kIterations = 80;
constexpr int kPlaceFirst = 50;  // at the latest after these, or once settled, the palm's place alone counts
constexpr double kSettledCost = 1e-20;  // m^2
constexpr double kSettledGain = 1e-6;   // of the cost, in one step

constexpr double kShort = 1e-3;  // m, short of the place
/// Across the body, far out to the side, raised, and low behind.
constexpr std::array<ArmJoints, 4> kOtherSeeds = {{{0.8, -0.8, 1.2, 1.5, 0.0, 0.0, 0.0},
                                                   {0.5, 0.9, -0.8, 1.2, 0.0, 0.0, 0.0},
                                                   {2.4, 0.2, 0.0, 1.0, 0.0, 0.0, 0.0},
                                                   {-0.9, -0.2, 0.5, 0.8, 0.0, 0.0, 0.0}}};

const DofInfo& jointInfo(std::size_t j) {
  return dofTable()[index(Dof::ShoulderFlexion) + j];
}

/// Rotation vector (axis times angle) that turns `from` into `to`.
Coord3 turnBetween(const TransformMatrix& from, const TransformMatrix& to) {
  const Quaternion q = quaternion(to.linear() * from.linear().rigidInverse());
  const Coord3 axis{q.x, q.y, q.z};
  const double sine = norm(axis);
  if (sine < 1e-12) return {};
  const double angle = 2.0 * std::atan2(sine, std::abs(q.w));
  return axis * ((q.w < 0.0 ? -angle : angle) / sine);
}

using Row = std::array<double, kArmJointCount>;
using Matrix = std::array<Row, kArmJointCount>;

/// Solves A x = b for a symmetric positive definite A (Cholesky).
Row solveSymmetric(Matrix a, Row b) {
  for (std::size_t i = 0; i < kArmJointCount; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(sum) : sum / a[j][j];
    }
  }
  for (std::size_t i = 0; i < kArmJointCount; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = kArmJointCount; i-- > 0;) {
    for (std::size_t k = i + 1; k < kArmJointCount; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

/// What the palm is to do, and how far it is from it.
struct Goal {
  Coord3 palm;
  const TransformMatrix* orientation;
};

struct Error {
  Coord3 place;  // m
  Coord3 turn;   // rad
  double cost(double angle_weight) const {
    return dot(place, place) + angle_weight * angle_weight * dot(turn, turn);
  }
};

Error errorOf(const ArmPose& pose, const Goal& goal) {
  Error e;
  e.place = goal.palm - pose.palm;
  if (goal.orientation != nullptr) e.turn = turnBetween(pose.t_shoulder_hand, *goal.orientation);
  return e;
}

/// Gradient and Gauss-Newton matrix of the cost; `place` and `turn` are the Jacobian's columns.
struct Slope {
  std::array<Coord3, kArmJointCount> place;
  std::array<Coord3, kArmJointCount> turn;
};

/// The damped step (Wampler 1986, eq. 10). A joint at its limit that would be pushed beyond is left out.
ArmJoints dampedStep(const ArmJoints& joints, const Slope& slope, const Error& error, double angle_weight,
                     double damping) {
  const double w2 = angle_weight * angle_weight;
  std::array<bool, kArmJointCount> fixed{};
  for (;;) {
    Matrix a{};
    Row b{};
    for (std::size_t i = 0; i < kArmJointCount; ++i) {
      a[i][i] = damping;
      if (fixed[i]) continue;
      b[i] = dot(slope.place[i], error.place) + w2 * dot(slope.turn[i], error.turn);
      for (std::size_t j = 0; j < kArmJointCount; ++j) {
        if (!fixed[j])
          a[i][j] += dot(slope.place[i], slope.place[j]) + w2 * dot(slope.turn[i], slope.turn[j]);
      }
    }
    const Row change = solveSymmetric(a, b);
    ArmJoints next{};
    bool again = false;
    for (std::size_t i = 0; i < kArmJointCount; ++i) {
      const DofInfo& limit = jointInfo(i);
      next[i] = std::clamp(joints[i] + change[i], limit.min, limit.max);
      const bool pushed = !fixed[i] && change[i] != 0.0 && next[i] == joints[i];
      fixed[i] = fixed[i] || pushed;
      again = again || pushed;
    }
    if (!again) return next;
  }
}

/// Each joint's axis and a point on it, in the shoulder frame, give the columns of the Jacobian.
Slope slopeAt(const TransformMatrix& base, const ArmPose& pose) {
  const Coord3 elbow = pose.t_shoulder_forearm.origin();
  const Coord3 wrist = pose.t_shoulder_hand.origin();
  const Coord3 hinge = ArmKinematics::hingeFrame().vector({0.0, 0.0, 1.0});
  const Coord3 radial = pose.t_shoulder_forearm.vector({0.0, 1.0, 0.0});
  const std::array<Coord3, kArmJointCount> axes = {base.vector({1.0, 0.0, 0.0}),
                                                   pose.t_shoulder_flexed.vector({0.0, 0.0, 1.0}),
                                                   pose.t_shoulder_abducted.vector({0.0, 1.0, 0.0}),
                                                   pose.t_shoulder_upper.vector(hinge),
                                                   pose.t_shoulder_forearm.vector({1.0, 0.0, 0.0}),
                                                   pose.t_shoulder_hand.vector({0.0, 0.0, 1.0}),
                                                   radial};
  const std::array<Coord3, kArmJointCount> points = {Coord3{}, Coord3{}, Coord3{}, elbow,
                                                     elbow,    wrist,    wrist};
  Slope slope;
  for (std::size_t i = 0; i < kArmJointCount; ++i) {
    slope.place[i] = cross(axes[i], pose.palm - points[i]);
    slope.turn[i] = axes[i];
  }
  return slope;
}

}  // namespace

ArmKinematics::Solution ArmKinematics::descend(const Coord3& palm, const TransformMatrix* orientation,
                                               const ArmJoints& seed) const {
  const Goal goal{palm, orientation};
  ArmJoints joints = seed;
  for (std::size_t i = 0; i < kArmJointCount; ++i)
    joints[i] = std::clamp(joints[i], jointInfo(i).min, jointInfo(i).max);
  ArmPose now = pose(joints);
  Error error = errorOf(now, goal);
  double damping = 1e-4;
  double angle_weight = orientation != nullptr ? kAngleWeight : 0.0;
  for (int k = 0; k < kIterations; ++k) {
    const double cost = error.cost(angle_weight);
    const ArmJoints next = dampedStep(joints, slopeAt(base_, now), error, angle_weight, damping);
    const ArmPose tried = pose(next);
    const Error tried_error = errorOf(tried, goal);
    const double gain = cost - tried_error.cost(angle_weight);
    if (gain > 0.0) {
      joints = next, now = tried, error = tried_error;
      damping = std::max(1e-10, damping / 4.0);
    } else {
      damping = std::min(1.0, damping * 4.0);
    }
    const bool settled =
        cost < kSettledCost || (gain >= 0.0 && gain < kSettledGain * cost) || k == kPlaceFirst;
    if (!settled) continue;
    if (angle_weight == 0.0) break;
    angle_weight = 0.0;
  }
  return {joints, norm(error.place), norm(error.turn)};
}

ArmKinematics::Solution ArmKinematics::solve(const Coord3& palm, const TransformMatrix* orientation,
                                             const ArmJoints& seed) const {
  Solution best = descend(palm, orientation, seed);
  for (const ArmJoints& other : kOtherSeeds) {
    if (best.position_error_m < kShort) break;
    const Solution tried = descend(palm, orientation, other);
    if (tried.position_error_m < best.position_error_m) best = tried;
  }
  return best;
}

}  // namespace coherency
