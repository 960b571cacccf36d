// What cannot be a world, and what one is told of it.

#include <stdexcept>

#include <gtest/gtest.h>

#include "common/config/TomlTable.h"
#include "tests/scenes/Support.h"

namespace coherency {
namespace {

using namespace scenes;

ObjectPlacement placed(const std::string& kind, const std::string& name, double x, double z) {
  ObjectPlacement placement;
  placement.kind = kind;
  placement.name = name;
  placement.place = basePose(x, z, 0.0);
  return placement;
}

/// The laboratory with one thing more. What it is refused for must name all `words`.
void expectRefused(const ObjectPlacement& more, const std::vector<std::string>& words) {
  SceneDescription description = described("laboratory");
  description.objects.push_back(more);
  try {
    const Scene scene(description, Rig{});
    FAIL() << "'" << more.name << "' was accepted";
  } catch (const std::invalid_argument& refused) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(refused.what()).find(word), std::string::npos)
          << word << " is not in: " << refused.what();
  }
}

TEST(Refused, KindsThatThereAreNot) {
  expectRefused(placed("sofa", "red sofa", 0.0, 2.0), {"red sofa", "'sofa'", "armchair", "laboratory"});
}

TEST(Refused, OneNameForTwo) {
  expectRefused(placed("plant", "red block", 2.0, 2.0), {"'red block'", "another name"});
}

TEST(Refused, ATableInAWall) {
  expectRefused(placed("table", "second table", -3.2, 1.5), {"second table", "left wall", "mm"});
}

TEST(Refused, ABlockInTheTable) {
  ObjectPlacement block = placed("block", "fourth block", 0.4, -1.2);
  block.place.y_nm = 700'000'000;
  expectRefused(block, {"fourth block", "table"});
}

TEST(Refused, WhatStandsWhereOneBegins) {
  expectRefused(placed("plant", "palm", 0.0, 1.25), {"palm", "master system"});
}

TEST(Refused, ColoursAndCountsWhereThereAreNone) {
  ObjectPlacement desk = placed("desk", "green desk", 2.0, 2.0);
  desk.colour = "#00ff00";
  expectRefused(desk, {"green desk", "colour"});
  desk = placed("desk", "many desks", 2.0, 2.0);
  desk.count = 3;
  expectRefused(desk, {"many desks", "count"});
  expectRefused(placed("grid", "no grid", 2.0, 2.0), {"no grid", "count"});
}

TEST(Refused, ScenesThatThereAreNotAreAnsweredWithThoseThereAre) {
  try {
    described("atlantis");
    FAIL();
  } catch (const ConfigError& error) {
    const std::string message = error.what();
    for (const char* name : {"atlantis", "blocks", "corridor", "grid", "laboratory", "look", "targets"})
      EXPECT_NE(message.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace coherency
