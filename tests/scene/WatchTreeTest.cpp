// Watches in a tree that grows, shrinks and dies.

#include <algorithm>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/scene/WatchSupport.h"

namespace coherency {
namespace {

using enum ObjectChange;

TEST(WatchTree, HearsOfMembersThatComeAndGo) {
  VRObject parent("parent"), other("other");
  auto child = std::make_unique<VRObject>("child");
  Recorder of_parent(parent), of_child(*child);
  parent.addMember(child.get());
  EXPECT_EQ(of_parent.heard(), Changes{Restructured});
  parent.removeMember(child.get());
  EXPECT_EQ(of_parent.heard(), Changes{Restructured});
  parent.addMember(child.get());
  EXPECT_TRUE(of_child.heard().empty()) << "whose member it is, its parent tells";
  child.reset();
  EXPECT_EQ(of_parent.heard(), (Changes{Restructured, Restructured}));
  EXPECT_EQ(of_child.heard(), Changes{Died});
  EXPECT_EQ(of_child.object(), nullptr);
}

TEST(WatchTree, IsOfOneObjectAlone) {
  VRObject root("root"), middle("middle"), leaf("leaf"), twig("twig");
  root.addMember(&middle);
  middle.addMember(&leaf);
  Recorder watch(middle);
  root.setPosition(1.0, 0.0, 0.0);
  leaf.setPosition(1.0, 0.0, 0.0);
  leaf.addMember(&twig);
  EXPECT_TRUE(watch.heard().empty());
}

TEST(WatchTree, GoesOnWithWhatHasLeftTheTree) {
  VRObject child("child");
  Recorder watch(child);
  {
    VRObject parent("parent");
    parent.addMember(&child);
    Recorder of_parent(parent);
  }
  EXPECT_TRUE(watch.heard().empty());
  EXPECT_EQ(watch.object(), &child);
  child.setPosition(1.0, 0.0, 0.0);
  EXPECT_EQ(watch.heard(), Changes{Moved});
}

/// An object and three that watch it; whoever is left hears what there is to hear.
TEST(WatchTree, EveryOrderOfDeathIsSafe) {
  std::vector<std::size_t> order{0, 1, 2, 3};
  do {
    auto object = std::make_unique<VRObject>("object");
    std::vector<std::unique_ptr<Recorder>> watches(3);
    for (auto& watch : watches) watch = std::make_unique<Recorder>(*object);
    for (const std::size_t dying : order) {
      const bool alive = object != nullptr;
      if (dying < watches.size()) {
        watches[dying].reset();
        if (alive) object->translate({1.0, 0.0, 0.0});
      } else {
        object.reset();
      }
      const Changes expected = dying == watches.size() ? Changes{Died} : alive ? Changes{Moved} : Changes{};
      for (const auto& watch : watches) {
        if (watch == nullptr) continue;
        EXPECT_EQ(watch->heard(), expected);
        EXPECT_EQ(watch->object(), object.get());
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

constexpr std::size_t kDeep = 10'000;

/// Ten thousand objects, each the only member of the one before, and all of them watched.
struct DeepChain {
  DeepChain() {
    for (std::size_t i = 0; i < kDeep; ++i) {
      objects.push_back(std::make_unique<VRObject>(std::to_string(i)));
      if (i > 0) objects[i - 1]->addMember(objects[i].get());
    }
    for (const auto& object : objects) watches.push_back(std::make_unique<Recorder>(*object));
  }
  std::vector<std::unique_ptr<VRObject>> objects;
  std::vector<std::unique_ptr<Recorder>> watches;
};

TEST(WatchTree, TenThousandDeepEachIsToldOfItsOwn) {
  DeepChain chain;
  for (std::size_t i = 0; i < kDeep; i += 7) chain.objects[i]->translate({0.0, 1.0, 0.0});
  for (std::size_t i = 0; i < kDeep; ++i)
    ASSERT_EQ(chain.watches[i]->heard(), i % 7 == 0 ? Changes{Moved} : Changes{}) << i;
}

TEST(WatchTree, ADeepChainDiesFromEitherEndBeforeWhoWatchesIt) {
  DeepChain from_the_root;
  for (std::size_t i = 0; i < kDeep; ++i) {
    from_the_root.objects[i].reset();
    ASSERT_EQ(from_the_root.watches[i]->heard(), Changes{Died}) << i;
  }
  DeepChain from_the_leaf;
  for (std::size_t i = kDeep; i-- > 0;) {
    from_the_leaf.objects[i].reset();
    const Changes expected = i + 1 == kDeep ? Changes{Died} : Changes{Restructured, Died};
    ASSERT_EQ(from_the_leaf.watches[i]->heard(), expected) << i;
  }
}

TEST(WatchTree, OutlivesWhoWatchedIt) {
  DeepChain chain;
  for (std::size_t i = 0; i < kDeep; i += 2) chain.watches[i].reset();
  for (const auto& object : chain.objects) object->translate({0.0, 1.0, 0.0});
  for (std::size_t i = 1; i < kDeep; i += 2) ASSERT_EQ(chain.watches[i]->heard(), Changes{Moved}) << i;
  chain.watches.clear();
  for (const auto& object : chain.objects) object->translate({0.0, 1.0, 0.0});
  EXPECT_EQ(chain.objects.front()->position(), Coord3(0.0, 2.0, 0.0));
}

}  // namespace
}  // namespace coherency
