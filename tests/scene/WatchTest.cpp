// What one who watches an object hears of it, and what is refused.

#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/scene/Mobility.h"
#include "common/scene/Primitives.h"
#include "tests/math/Random.h"
#include "tests/scene/Support.h"
#include "tests/scene/WatchSupport.h"

namespace coherency {
namespace {

using enum ObjectChange;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// One of the ways to move an object; some leave it where it is.
void moveSomehow(VRObject& object) {
  switch (*rc::gen::inRange(0, 9)) {
    case 0:
      return object.setTransform(random::affine(5.0));
    case 1:
      return object.setPosition(random::vector(5.0));
    case 2:
      return object.setOrientation(random::rotationMatrix());
    case 3:
      return object.translate({0.0, *rc::gen::inRange(0, 2) * 1.0, 0.0});
    case 4:
      return object.rotate(TransformMatrix::rotationX(*rc::gen::inRange(0, 2) * 0.5));
    case 5:
      return object.scale({*rc::gen::inRange(1, 3) * 1.0, 1.0, 1.0});
    case 6:
      return object.setGlobalTransform(random::rigid(5.0));
    case 7:
      return object.setGlobalPosition(random::vector(5.0));
    default:
      return object.setTransform(object.transform());
  }
}

RC_GTEST_PROP(Watch, HearsOfEveryMoveOnceWhenItIsMadeAndOfNothingElse, ()) {
  VRObject carrier("carrier"), object("object");
  carrier.setTransform(random::rigid(5.0));
  carrier.addMember(&object);
  Recorder watch(object);
  for (int i = 0; i < 12; ++i) {
    const TransformMatrix before = object.transform();
    moveSomehow(object);
    RC_ASSERT(watch.heard() == (object.transform() == before ? Changes{} : Changes{Moved}));
    if (!(object.transform() == before)) RC_ASSERT(watch.seen() == object.transform());
  }
}

RC_GTEST_PROP(Watch, RefusesToMoveWhatIsDeclaredFixedAndItStays, ()) {
  VRObject room("room"), wall("wall");
  room.addMember(&wall);
  wall.attach(Fixed{});
  moveSomehow(wall);  // nothing was made of it yet
  const TransformMatrix before = wall.transform();
  {
    Recorder first(wall), second(wall);
    for (int i = 0; i < 12; ++i) {
      try {
        moveSomehow(wall);
      } catch (const std::logic_error&) {
      }
      RC_ASSERT(wall.transform() == before);
      RC_ASSERT(first.heard().empty() && second.heard().empty());
    }
  }
  wall.translate({1.0, 0.0, 0.0});
  RC_ASSERT(wall.position() == before.origin() + Coord3(1.0, 0.0, 0.0));
}

TEST(Watch, SaysWhatWasRefusedAndWhatWouldBeRight) {
  VRObject room("room"), wall("wall");
  room.addMember(&wall);
  wall.attach(Fixed{});
  const Recorder watch(wall);
  expectRefusal<std::logic_error>([&] { wall.setPosition(1.0, 0.0, 0.0); }, "room/wall", "Fixed", "Moving");
  EXPECT_NO_THROW(wall.setPosition(0.0, 0.0, 0.0)) << "where it is already";
  EXPECT_NO_THROW(room.setPosition(1.0, 0.0, 0.0)) << "it goes with what it is fixed to";
  const Recorder deaf(room, Watched::AllButMoves);
  room.attach(Fixed{});
  EXPECT_NO_THROW(room.setPosition(2.0, 0.0, 0.0)) << "nobody there minds its place";
}

TEST(Watch, OneThatRefusesKeepsAllOthersFromBeingTold) {
  struct Refusing : Recorder {
    using Recorder::Recorder;
    void mayMove() const override { throw std::logic_error("no"); }
  };
  VRObject object;
  Recorder before(object);
  Refusing refusing(object);
  Recorder after(object);
  EXPECT_THROW(object.setPosition(1.0, 0.0, 0.0), std::logic_error);
  EXPECT_EQ(object.position(), Coord3());
  for (Recorder* watch : {&before, static_cast<Recorder*>(&refusing), &after})
    EXPECT_TRUE(watch->heard().empty());
}

TEST(Watch, MayBeDeafToMoves) {
  Box box;
  Recorder watch(box, Watched::AllButMoves);
  box.setPosition(1.0, 0.0, 0.0);
  EXPECT_TRUE(watch.heard().empty());
  box.setColour(1.0, 0.0, 0.0);
  box.setSize({2.0, 2.0, 2.0});
  EXPECT_EQ(watch.heard(), (Changes{Repainted, Reshaped}));
}

/// Each done twice: the second time changes nothing.
TEST(Watch, HearsOfShapesAndMaterialsOnce) {
  Box box;
  Cylinder cylinder;
  Ellipsoid ellipsoid;
  Rectangle rectangle;
  Polygon polygon;
  Polyhedron solid;
  const std::vector<Coord3> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  struct Write {
    const char* what;
    VRObject& object;
    std::function<void()> write;
    Changes heard;
  };
  const Write writes[] = {
      {"box",
       box,
       [&] {
         box.setSize({1, 2, 3});
       },
       {Reshaped}},
      {"cylinder", cylinder, [&] { cylinder.setSize(0.2, 1.0, 12); }, {Reshaped, Reshaped}},
      {"frustum", cylinder, [&] { cylinder.setTapered(0.2, 0.1, 1.0, 12); }, {Reshaped, Reshaped}},
      {"ellipsoid",
       ellipsoid,
       [&] {
         ellipsoid.setSize({1, 1, 2}, 8);
       },
       {Reshaped}},
      {"rectangle", rectangle, [&] { rectangle.setSize(2, 3); }, {Reshaped}},
      {"polygon", polygon, [&] { polygon.setShape(triangle); }, {Reshaped}},
      {"solid",
       solid,
       [&] {
         solid.setShape(triangle, {{0, 1, 2}});
       },
       {Reshaped}},
      {"its other side",
       solid,
       [&] {
         solid.setShape(triangle, {{0, 2, 1}});
       },
       {Reshaped}},
      {"smooth",
       solid,
       [&] {
         solid.setShape(triangle, {{0, 2, 1}}, true);
       },
       {Reshaped}},
      {"crease", solid, [&] { solid.setCreaseAngle(0.1); }, {Reshaped}},
      {"material",
       solid,
       [&] {
         solid.setMaterial({{1, 0, 0}, 0.5, 0.5});
       },
       {Repainted}},
      {"gloss",
       solid,
       [&] {
         solid.setMaterial({{1, 0, 0}, 0.4, 0.5});
       },
       {Repainted}},
      {"emission",
       solid,
       [&] {
         solid.setMaterial({{1, 0, 0}, 0.4, 0.1});
       },
       {Repainted}},
      {"colour", solid, [&] { solid.setColour(1, 0, 1); }, {Repainted}},
      {"polygon's material",
       polygon,
       [&] {
         polygon.setMaterial({{1, 0, 0}, 0.5, 0.5});
       },
       {Repainted}},
      {"polygon's colour", polygon, [&] { polygon.setColour(1, 1, 0); }, {Repainted}},
  };
  for (const Write& w : writes) {
    Recorder watch(w.object);
    w.write();
    EXPECT_EQ(watch.heard(), w.heard) << w.what;
    w.write();
    EXPECT_TRUE(watch.heard().empty()) << w.what << ", again";
  }
  EXPECT_EQ(solid.faces()->material, (Material{{1, 0, 1}, 0.4, 0.1})) << "a colour leaves the rest";
}

TEST(Watch, HearsNothingOfWhatASetterRefuses) {
  Box box;
  Recorder watch(box);
  EXPECT_THROW(box.setPosition(kNan, 0.0, 0.0), std::domain_error);
  EXPECT_THROW(box.setOrientation(TransformMatrix::scaling({kNan, 1.0, 1.0})), std::domain_error);
  EXPECT_THROW(box.setSize({1.0, -1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(box.setShape({{0, 0, 0}}, {{0, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(box.setCreaseAngle(-1.0), std::invalid_argument);
  EXPECT_THROW(box.addMember(&box), std::invalid_argument);
  EXPECT_THROW(box.removeMember(&box), std::invalid_argument);
  EXPECT_TRUE(watch.heard().empty());
}

TEST(Mobility, IsWhatAnObjectDeclaresAndNotBoth) {
  VRObject room("room"), door("door");
  room.addMember(&door);
  EXPECT_EQ(mobility(door), Mobility::Undeclared);
  room.attach(Moving{});
  EXPECT_EQ(mobility(door), Mobility::Undeclared) << "whatever it is part of";
  EXPECT_EQ(mobility(room), Mobility::Moving);
  door.attach(Fixed{});
  EXPECT_EQ(mobility(door), Mobility::Fixed);
  door.attach(Moving{});
  expectRefusal<std::invalid_argument>([&] { mobility(door); }, "room/door", "Fixed", "Moving",
                                       "one of them");
}

}  // namespace
}  // namespace coherency
