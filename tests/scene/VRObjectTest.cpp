// Membership: who may be whose member, and what happens when one of them dies.

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "common/scene/VRObject.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

using Refused = std::invalid_argument;

TEST(VRObjectMembers, KnowTheirParentAndKeepTheirOrder) {
  VRObject parent("parent"), a("a"), b("b");
  parent.addMember(&a);
  parent.addMember(&b);
  EXPECT_TRUE(std::ranges::equal(parent.members(), std::vector<VRObject*>{&a, &b}));
  EXPECT_EQ(a.parent(), &parent);
  EXPECT_EQ(parent.parent(), nullptr);
}

TEST(VRObjectMembers, CanBeRemovedAndGivenToAnother) {
  VRObject first("first"), second("second"), child("child");
  child.setPosition(1.0, 2.0, 3.0);
  first.addMember(&child);
  first.removeMember(&child);
  EXPECT_TRUE(first.members().empty());
  EXPECT_EQ(child.parent(), nullptr);
  EXPECT_EQ(child.position(), Coord3(1.0, 2.0, 3.0));
  second.addMember(&child);
  EXPECT_EQ(child.parent(), &second);
}

TEST(VRObjectMembers, NullIsRefused) {
  VRObject parent("room");
  expectRefusal<Refused>([&] { parent.addMember(nullptr); }, "room", "null");
  expectRefusal<Refused>([&] { parent.removeMember(nullptr); }, "room", "null");
}

TEST(VRObjectMembers, ASecondParentIsRefusedAndBothAreNamed) {
  VRObject table("table"), shelf("shelf"), block("block");
  table.addMember(&block);
  expectRefusal<Refused>([&] { shelf.addMember(&block); }, "shelf", "block", "table", "remove");
  expectRefusal<Refused>([&] { table.addMember(&block); }, "already a member");
  EXPECT_EQ(block.parent(), &table);
  EXPECT_TRUE(shelf.members().empty());
  EXPECT_EQ(table.members().size(), 1u);
}

TEST(VRObjectMembers, CyclesAreRefused) {
  VRObject a("a"), b("b"), c("c");
  expectRefusal<Refused>([&] { a.addMember(&a); }, "'a'", "cycle");
  a.addMember(&b);
  b.addMember(&c);
  expectRefusal<Refused>([&] { c.addMember(&a); }, "a/b/c", "cycle");
  EXPECT_EQ(a.parent(), nullptr);
  EXPECT_TRUE(c.members().empty());
}

TEST(VRObjectMembers, AStrangerIsNotRemoved) {
  VRObject parent("parent"), child("child"), stranger("stranger");
  parent.addMember(&child);
  expectRefusal<Refused>([&] { parent.removeMember(&stranger); }, "parent", "stranger", "not its member");
  EXPECT_EQ(parent.members().size(), 1u);
}

TEST(VRObjectLife, ADyingMemberLeavesItsParentAndLetsGoOfItsOwn) {
  VRObject root("root"), leaf("leaf"), sibling("sibling");
  {
    VRObject middle("middle");
    root.addMember(&middle);
    root.addMember(&sibling);
    middle.addMember(&leaf);
  }
  EXPECT_TRUE(std::ranges::equal(root.members(), std::vector<VRObject*>{&sibling}));
  EXPECT_EQ(leaf.parent(), nullptr);
}

TEST(VRObjectLife, ADyingParentLetsGoOfItsMembers) {
  auto parent = std::make_unique<VRObject>("parent");
  VRObject child("child");
  parent->addMember(&child);
  parent.reset();
  EXPECT_EQ(child.parent(), nullptr);
  EXPECT_EQ(child.path(), "child");
  EXPECT_EQ(child.globalTransform(), TransformMatrix());
}

TEST(VRObjectLife, EveryOrderOfDeathLeavesTheRestConsistent) {
  std::vector<int> order{0, 1, 2, 3};
  do {
    std::vector<std::unique_ptr<VRObject>> objects;
    for (int i = 0; i < 4; ++i) objects.push_back(std::make_unique<VRObject>(std::to_string(i)));
    objects[0]->addMember(objects[1].get());
    objects[0]->addMember(objects[2].get());
    objects[1]->addMember(objects[3].get());
    for (const int dying : order) {
      objects[static_cast<std::size_t>(dying)].reset();
      for (const auto& object : objects) {
        if (!object) continue;
        for (const VRObject* member : object->members()) EXPECT_EQ(member->parent(), object.get());
        if (object->parent() == nullptr) continue;
        const auto& siblings = object->parent()->members();
        EXPECT_EQ(std::count(siblings.begin(), siblings.end(), object.get()), 1);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(VRObjectPath, NamesFromTheRootDown) {
  VRObject room("room"), unnamed, cup("cup");
  room.addMember(&unnamed);
  unnamed.addMember(&cup);
  EXPECT_EQ(cup.path(), "room/?/cup");
  unnamed.setName("table");
  EXPECT_EQ(cup.path(), "room/table/cup");
  EXPECT_EQ(room.path(), "room");
}

}  // namespace
}  // namespace coherency
