// Local and global terms in the world tree, shallow and very deep.

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/scene/Primitives.h"
#include "common/scene/VRObject.h"
#include "tests/math/Random.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

struct Chain {
  VRObject root{"root"}, middle{"middle"}, leaf{"leaf"};

  Chain() {
    root.addMember(&middle);
    middle.addMember(&leaf);
  }
};

RC_GTEST_PROP(VRObjectTree, MovingAParentMovesItsChildrenRigidly, ()) {
  Chain chain;
  chain.middle.setTransform(random::rigid(5.0));
  chain.leaf.setTransform(random::rigid(5.0));
  const TransformMatrix local = chain.leaf.transform();
  const TransformMatrix before = chain.leaf.globalTransform();
  const TransformMatrix motion = random::rigid(5.0);
  chain.root.setTransform(motion);
  RC_ASSERT(largestDifference(chain.leaf.globalTransform(), motion * before) < 1e-12);
  RC_ASSERT(chain.leaf.transform() == local);
}

RC_GTEST_PROP(VRObjectTree, GlobalTransformIsTheProductFromTheRootDown, ()) {
  Chain chain;
  for (VRObject* object : {&chain.root, &chain.middle, &chain.leaf})
    object->setTransform(random::affine(5.0));
  const TransformMatrix expected = chain.root.transform() * chain.middle.transform() * chain.leaf.transform();
  RC_ASSERT(largestDifference(chain.leaf.globalTransform(), expected) < 1e-9 * (1.0 + expected.maxScale()));
  RC_ASSERT(chain.leaf.globalPosition() == chain.leaf.globalTransform().origin());
  RC_ASSERT(chain.leaf.globalOrientation() == chain.leaf.globalTransform().linear());
}

RC_GTEST_PROP(VRObjectTree, WhatIsSetGloballyIsReadGlobally, ()) {
  Chain chain;
  chain.root.setTransform(random::rigid(5.0));
  chain.middle.setTransform(random::rigid(5.0) * TransformMatrix::scaling({2.0, 0.5, 1.0}));
  const TransformMatrix wanted = random::rigid(5.0);
  chain.leaf.setGlobalTransform(wanted);
  RC_ASSERT(largestDifference(chain.leaf.globalTransform(), wanted) < 1e-12);

  const Coord3 place = random::vector(5.0);
  chain.leaf.setGlobalPosition(place);
  RC_ASSERT(norm(chain.leaf.globalPosition() - place) < 1e-12);
  RC_ASSERT(largestDifference(chain.leaf.globalOrientation(), wanted.linear()) < 1e-12);

  const TransformMatrix facing = random::rotationMatrix();
  chain.leaf.setGlobalOrientation(facing);
  RC_ASSERT(largestDifference(chain.leaf.globalOrientation(), facing) < 1e-12);
  RC_ASSERT(norm(chain.leaf.globalPosition() - place) < 1e-12);
}

TEST(VRObjectTree, GlobalIsLocalForARoot) {
  VRObject root;
  root.setGlobalPosition({1.0, 2.0, 3.0});
  root.setGlobalOrientation(TransformMatrix::rotationX(0.5));
  EXPECT_EQ(root.position(), Coord3(1.0, 2.0, 3.0));
  EXPECT_EQ(root.orientation(), TransformMatrix::rotationX(0.5));
}

TEST(VRObjectTree, ASingularAncestorIsRefusedByNameAndNothingChanges) {
  Chain chain;
  chain.root.setOrientation(TransformMatrix::scaling({1.0, 0.0, 1.0}));
  const TransformMatrix before = chain.leaf.transform();
  expectRefusal<std::domain_error>(
      [&] {
        chain.leaf.setGlobalPosition({1, 1, 1});
      },
      "root/middle/leaf", "condition");
  expectRefusal<std::domain_error>([&] { chain.leaf.setGlobalTransform({}); }, "root/middle/leaf",
                                   "condition");
  expectRefusal<std::domain_error>([&] { chain.leaf.setGlobalOrientation({}); }, "root/middle/leaf",
                                   "condition");
  EXPECT_EQ(chain.leaf.transform(), before);
}

TEST(VRObjectTree, CountsPolygonsOfTheWholeTree) {
  Box box;
  Cylinder cylinder(0.5, 1.0, 10);
  VRObject group;
  EXPECT_EQ(group.polygonCount(), 0u);
  box.addMember(&cylinder);
  group.addMember(&box);
  EXPECT_EQ(group.polygonCount(), 6u + 12u);
  EXPECT_EQ(cylinder.polygonCount(), 12u);
  EXPECT_EQ(group.faces(), nullptr);
}

TEST(VRObjectTree, VisitsParentsFirstInTheOrderOfAddition) {
  VRObject root("root"), a("a"), a1("a1"), a2("a2"), b("b");
  root.addMember(&a);
  root.addMember(&b);
  a.addMember(&a1);
  a.addMember(&a2);
  a.setPosition(1.0, 0.0, 0.0);
  a2.setPosition(0.0, 1.0, 0.0);
  std::string order;
  forEachObject(root, TransformMatrix::translation({0.0, 0.0, 5.0}),
                [&](const VRObject& object, const auto& t) {
                  order += object.name() + ' ';
                  if (&object == &a2) {
                    EXPECT_EQ(t.origin(), Coord3(1.0, 1.0, 5.0));
                  }
                });
  EXPECT_EQ(order, "root a a1 a2 b ");
}

constexpr int kDeep = 10'000;

/// Ten thousand objects, each the only member of the one before.
std::vector<std::unique_ptr<VRObject>> deepChain() {
  std::vector<std::unique_ptr<VRObject>> chain;
  for (int i = 0; i < kDeep; ++i) {
    chain.push_back(std::make_unique<VRObject>(i == 0 ? "root" : ""));
    chain.back()->setPosition(0.001, 0.0, 0.0);
    if (i > 0) chain[static_cast<std::size_t>(i - 1)]->addMember(chain.back().get());
  }
  return chain;
}

TEST(VRObjectTree, TenThousandDeepIsNoMatter) {
  const auto chain = deepChain();
  VRObject& last = *chain.back();
  expectNear(last.globalPosition(), {0.001 * kDeep, 0.0, 0.0}, 1e-9);
  chain.front()->setOrientation(TransformMatrix::rotationZ(1.5707963267948966));
  expectNear(last.globalPosition(), {0.001, 0.001 * (kDeep - 1), 0.0}, 1e-9);
  last.setGlobalPosition({1.0, 2.0, 3.0});
  expectNear(last.globalPosition(), {1.0, 2.0, 3.0}, 1e-9);
  EXPECT_EQ(last.path().size(), 4u + 2u * (kDeep - 1));
  int visited = 0;
  forEachObject(*chain.front(), {}, [&](const VRObject&, const TransformMatrix&) { ++visited; });
  EXPECT_EQ(visited, kDeep);
  EXPECT_EQ(chain.front()->polygonCount(), 0u);
  expectRefusal<std::invalid_argument>([&] { last.addMember(chain.front().get()); }, "cycle");
}

TEST(VRObjectTree, ADeepChainDiesFromEitherEnd) {
  auto from_the_root = deepChain();
  for (auto& object : from_the_root) object.reset();
  auto from_the_leaf = deepChain();
  while (from_the_leaf.size() > 1) {
    from_the_leaf.pop_back();
    EXPECT_TRUE(from_the_leaf.back()->members().empty());
  }
}

/// A hundred thousand objects held in a vector, as the boxes of a large scene are.
TEST(VRObjectTree, ManyMembersDieOneByOneAtAConstantCost) {
  constexpr std::size_t kMany = 100'000;
  VRObject parent("parent");
  std::vector<std::unique_ptr<VRObject>> members;
  for (std::size_t i = 0; i < kMany; ++i) {
    members.push_back(std::make_unique<VRObject>());
    parent.addMember(members.back().get());
  }
  std::size_t moved = 0;  // places in the parent's list whose contents were shifted
  for (std::size_t i = 0; i < kMany; ++i) {
    const auto before = parent.members();
    members[i].reset();
    const auto after = parent.members();
    ASSERT_EQ(after.size(), kMany - i - 1);
    if (after.empty()) break;
    ASSERT_EQ(after.front(), members[i + 1].get());
    if (after.data() != before.data() + 1) moved += after.size();
  }
  EXPECT_LE(moved, 2 * kMany);
}

TEST(VRObjectTree, MembersKeepTheirOrderWhoeverLeaves) {
  std::vector<std::unique_ptr<VRObject>> objects;
  VRObject parent("parent");
  for (int i = 0; i < 9; ++i) {
    objects.push_back(std::make_unique<VRObject>(std::to_string(i)));
    parent.addMember(objects.back().get());
  }
  const auto names = [&] {
    std::string all;
    for (const VRObject* member : parent.members()) all += member->name();
    return all;
  };
  for (const std::size_t leaving : {0U, 1U, 4U, 8U, 7U}) parent.removeMember(objects[leaving].get());
  EXPECT_EQ(names(), "2356");
  parent.addMember(objects[0].get());
  EXPECT_EQ(names(), "23560");
  for (int i = 0; i < 100; ++i) {  // first out and in again: the list must not grow for ever
    VRObject* first = parent.members().front();
    parent.removeMember(first);
    parent.addMember(first);
  }
  EXPECT_EQ(names(), "23560");
  expectRefusal<std::invalid_argument>([&] { parent.removeMember(objects[8].get()); }, "8", "not its member");
}

}  // namespace
}  // namespace coherency
