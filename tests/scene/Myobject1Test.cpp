// The paper's example of an object definition (section III.B), in this library's spelling.

#include <gtest/gtest.h>

#include "common/scene/Primitives.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

class Myobject2 : public VRObject {
  Cylinder cylinder;

 public:
  Myobject2() : VRObject("Myobject2") { addMember(&cylinder); }
};

class Myobject1 : public VRObject {
  Box box1, box2;        // primitive
  Myobject2 sub_object;  // another object (already defined)

 public:
  Myobject1();  // constructor
};

Myobject1::Myobject1() {
  // set local position of child objects
  box1.setPosition(-1.0, 0.0, 0.0);
  box2.setPosition(1.0, 0.0, 0.0);
  sub_object.setPosition(-2.0, 0.0, -3.0);
  // register these objects as children of this object
  addMember(&box1);
  addMember(&box2);
  addMember(&sub_object);
}

TEST(Myobject1, HoldsItsMembersWhereTheListingPutsThem) {
  const Myobject1 object;
  ASSERT_EQ(object.members().size(), 3u);
  EXPECT_EQ(object.members()[0]->position(), Coord3(-1.0, 0.0, 0.0));
  EXPECT_EQ(object.members()[1]->position(), Coord3(1.0, 0.0, 0.0));
  EXPECT_EQ(object.members()[2]->position(), Coord3(-2.0, 0.0, -3.0));
  EXPECT_EQ(object.polygonCount(), 6u + 6u + 24u + 2u);
}

TEST(Myobject1, MovingItMovesItsMembersAndLeavesTheirLocalTransforms) {
  Myobject1 object;
  object.setPosition(10.0, 0.0, 0.0);
  object.setOrientation(TransformMatrix::rotationY(1.5707963267948966));  // -z goes to -x
  expectNear(object.members()[0]->globalPosition(), {10.0, 0.0, 1.0});
  expectNear(object.members()[1]->globalPosition(), {10.0, 0.0, -1.0});
  expectNear(object.members()[2]->globalPosition(), {7.0, 0.0, 2.0});
  EXPECT_EQ(object.members()[2]->position(), Coord3(-2.0, 0.0, -3.0));
}

}  // namespace
}  // namespace coherency
