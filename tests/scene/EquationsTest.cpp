// The equations of the paper's section III.A, each on the class library itself. O is the world's origin, A an
// object, S its sub-object, B the operator's body, H the head and V the eye.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/scene/Polygon.h"
#include "common/scene/VRObject.h"
#include "common/scene/ViewPoint.h"
#include "tests/math/Random.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

/// T p worked out element by element, for comparison with the library.
Coord3 timesColumn(const TransformMatrix& t, const Coord3& p) {
  double out[3];
  for (int row = 0; row < 3; ++row)
    out[row] = t(row, 0) * p.x + t(row, 1) * p.y + t(row, 2) * p.z + t(row, 3);
  return {out[0], out[1], out[2]};
}

void assertNear(const Coord3& a, const Coord3& b) {
  RC_ASSERT(norm(a - b) < 1e-11);
}

/// A point of A keeps its description [x, y, z, 1] in A wherever A is.
TEST(Equations, Eq1PointInOwnFrame) {
  const Coord3 p_a{0.25, -1.5, 3.0};
  VRObject carrier("carrier");
  Polygon a({p_a, {1.25, -1.5, 3.0}, {0.25, -0.5, 3.0}}, "A");
  carrier.addMember(&a);
  carrier.setPosition(7.0, 8.0, 9.0);
  a.setOrientation(YawPitchRoll{0.5, 0.2, -0.1});
  EXPECT_EQ(a.faces()->vertices[0], p_a);
  // The fourth coordinate is 1: the translation counts whole.
  EXPECT_EQ(TransformMatrix::translation({1.0, 2.0, 3.0}).point(p_a), p_a + Coord3(1.0, 2.0, 3.0));
}

RC_GTEST_PROP(Equations, Eq2PointInWorld, ()) {
  const TransformMatrix t_o_a = random::rigid(10.0);
  const Coord3 p_a = random::vector(10.0);
  VRObject a("A");
  a.setTransform(t_o_a);
  assertNear(a.globalTransform().point(p_a), timesColumn(t_o_a, p_a));
}

RC_GTEST_PROP(Equations, Eq3SubObjectPointInParent, ()) {
  const TransformMatrix t_a_s = random::rigid(10.0);
  const Coord3 p_s = random::vector(10.0);
  VRObject a("A");
  VRObject s("S");
  a.addMember(&s);
  a.setTransform(random::rigid(10.0));
  s.setTransform(t_a_s);
  assertNear(s.transform().point(p_s), timesColumn(t_a_s, p_s));
}

RC_GTEST_PROP(Equations, Eq4SubObjectPointInWorld, ()) {
  const Coord3 p_s = random::vector(10.0);
  VRObject a("A");
  VRObject s("S");
  a.addMember(&s);
  s.setTransform(random::rigid(10.0));
  for (int move = 0; move < 2; ++move) {  // right also after A has moved, as long as T_a_s is held
    a.setTransform(random::rigid(10.0));
    assertNear(s.globalTransform().point(p_s), timesColumn(a.transform(), timesColumn(s.transform(), p_s)));
  }
}

struct Operator {
  VRObject body{"body"};
  VRObject head{"head"};
  ViewPoint eye;

  Operator() {
    body.addMember(&head);
    eye.attachTo(&head);
    body.setTransform(random::rigid(10.0));
    head.setTransform(random::rigid(1.0));
    eye.setTransform(random::rigid(0.1));
  }
};

RC_GTEST_PROP(Equations, Eq5EyeInWorld, ()) {
  const Operator person;
  const Coord3 p_v = random::vector(10.0);
  const Coord3 p_b = timesColumn(person.head.transform(), timesColumn(person.eye.transform(), p_v));
  assertNear(person.eye.globalTransform().point(p_v), timesColumn(person.body.transform(), p_b));
}

RC_GTEST_PROP(Equations, Eq6ObjectThroughTheEye, ()) {
  const Operator person;
  const TransformMatrix t_o_s = random::affine(10.0);
  const TransformMatrix t_v_s = person.eye.viewing(t_o_s);
  RC_ASSERT(largestDifference(person.eye.globalTransform() * t_v_s, t_o_s) < 1e-11);
}

RC_GTEST_PROP(Equations, Eq7ViewingTransform, ()) {
  const Operator person;
  const TransformMatrix t_o_s = random::rigid(10.0);
  const Coord3 p_s = random::vector(10.0);
  // By hand: how far S's point lies along each of the eye's axes.
  const TransformMatrix t_o_v = person.eye.globalTransform();
  const Coord3 from_eye = timesColumn(t_o_s, p_s) - t_o_v.origin();
  const Coord3 seen{dot(from_eye, t_o_v.vector({1, 0, 0})), dot(from_eye, t_o_v.vector({0, 1, 0})),
                    dot(from_eye, t_o_v.vector({0, 0, 1}))};
  assertNear(person.eye.viewing(t_o_s).point(p_s), seen);
}

TEST(Equations, Eq7HoldsForAScaledCarrierAndRefusesASingularOne) {
  VRObject giant("giant");
  ViewPoint eye;
  eye.attachTo(&giant);
  eye.setPosition(0.0, 1.0, 0.0);
  giant.scale({2.0, 2.0, 2.0});
  expectNear(eye.viewing(TransformMatrix::translation({0.0, 2.0, -8.0})).origin(), {0.0, 0.0, -4.0});
  giant.setOrientation(TransformMatrix::scaling({1.0, 0.0, 1.0}));
  EXPECT_THROW(eye.viewing({}), std::domain_error);
}

TEST(Equations, AnEyeWithoutACarrierStandsInTheWorld) {
  ViewPoint eye;
  eye.setPosition(1.0, 2.0, 3.0);
  EXPECT_EQ(eye.carrier(), nullptr);
  EXPECT_EQ(eye.globalTransform(), TransformMatrix::translation({1.0, 2.0, 3.0}));
  EXPECT_EQ(eye.viewing(TransformMatrix::translation({1.0, 2.0, 0.0})).origin(), Coord3(0.0, 0.0, -3.0));
}

}  // namespace
}  // namespace coherency
