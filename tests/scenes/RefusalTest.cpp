// What cannot be a world, and what one is told of it.

#include <stdexcept>

#include <gtest/gtest.h>

#include "common/config/TomlTable.h"
#include "common/world/Places.h"
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

/// What the scene is refused for must name all `words`.
void expectRefused(const SceneDescription& description, const std::vector<std::string>& words,
                   std::uint64_t seed = 0) {
  try {
    const Scene scene(description, Rig{});
    scene.initialState(seed);
    FAIL() << "it was accepted";
  } catch (const std::invalid_argument& refused) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(refused.what()).find(word), std::string::npos)
          << word << " is not in: " << refused.what();
  }
}

/// The laboratory with one thing more.
void expectRefused(const ObjectPlacement& more, const std::vector<std::string>& words) {
  SceneDescription description = described("laboratory");
  description.objects.push_back(more);
  expectRefused(description, words);
}

TEST(Refused, KindsThatThereAreNot) {
  expectRefused(placed("sofa", "red sofa", 0.0, 2.0), {"red sofa", "'sofa'", "armchair", "laboratory"});
}

TEST(Refused, OneNameForTwo) {
  expectRefused(placed("plant", "red block", 2.0, 2.0), {"'red block'", "another name", "name = \""});
}

TEST(Refused, ATableInAWall) {
  expectRefused(placed("table", "second table", -3.2, 1.5), {"second table", "left wall", "mm"});
}

TEST(Refused, MeasuresThatNoBodyHasTogetherByTheRigsName) {
  Rig rig;
  rig.name = "spider";
  rig.trunk_length = 0.411;
  rig.shoulder_half_width = 0.111;
  rig.shoulder_drop = 0.135;
  rig.shoulder_tilt_up = -0.808;
  rig.shoulder_tilt_back = 0.807;
  rig.upper_arm = 0.208;
  rig.forearm = 0.572;
  rig.hand = 0.034;
  rig.seat_height = 1.375;
  rig.hip_half_width = 0.366;
  rig.thigh = 0.369;
  rig.shin = 0.626;
  rig.robot_scale = 1.421;
  try {
    const Scene scene(described("look"), rig);
    FAIL() << "it was accepted";
  } catch (const std::domain_error& refused) {
    EXPECT_NE(std::string(refused.what()).find("rig 'spider'"), std::string::npos) << refused.what();
    EXPECT_NE(std::string(refused.what()).find("default.toml"), std::string::npos) << refused.what();
  }
}

TEST(Accepted, EyesAloneBesideFurniture) {
  SceneDescription description;
  description.name = "only look";
  description.operator_shown = false;
  description.driving = false;
  description.start = basePose(0.0, -0.7, 0.0);
  description.objects = {placed("table", "table", 0.0, -1.2)};
  EXPECT_NO_THROW(Scene(description, Rig{}));
  description.operator_shown = true;
  expectRefused(description, {"master system", "table", "start"});
}

TEST(Accepted, OperatorsWhoseKneesDoNotGoUnderTheTableStandBack) {
  const Scene usual(described("laboratory"), Rig{});
  const BasePose where_the_file_says = described("laboratory").workplace;
  EXPECT_EQ(usual.workplace(Mode::Operator), where_the_file_says);
  Rig high;
  high.seat_height = 0.58;
  Rig large;
  for (const RigField& field : rigFields())
    if (field.name != "robot_scale" && !field.name.starts_with("shoulder_tilt")) large.*field.value *= 1.15;
  for (const Rig& rig : {high, large}) {
    const Scene scene(described("laboratory"), rig);
    const BasePose place = scene.workplace(Mode::Operator);
    EXPECT_GT(place.z_nm, where_the_file_says.z_nm);
    EXPECT_TRUE(standsFree(place, scene.world().model().master, scene.world().model()));
  }
}

TEST(Refused, ABlockInTheTable) {
  ObjectPlacement block = placed("block", "fourth block", 0.4, -1.2);
  block.place.y_nm = 700'000'000;
  expectRefused(block, {"fourth block", "table"});
}

TEST(Refused, WhatStandsWhereOneBegins) {
  expectRefused(placed("plant", "palm", 0.0, 1.25), {"palm", "master system", "its start"});
  expectRefused(placed("plant", "palm", 0.0, -0.3), {"palm", "master system", "its workplace"});
  expectRefused(placed("plant", "palm", -2.0, -1.98), {"palm", "slave robot", "its start"});
}

TEST(Refused, OneVehicleInTheOther) {
  SceneDescription description = described("laboratory");
  description.robot->start = description.start;
  expectRefused(description, {"master system", "slave robot", "start"});
  description = described("laboratory");
  description.robot->start = description.workplace;
  description.robot->start.z_nm += 300'000'000;
  expectRefused(description, {"master system", "slave robot", "workplace"});
}

TEST(Refused, NamesThatCannotBe) {
  for (const char* name : {"", "my/table", "virtual human", "slave robot", "master system"})
    expectRefused(placed("plant", name, 2.0, 2.0), {"'" + std::string(name) + "'", "no '/'"});
}

TEST(Refused, WhereOneBeginsInSomethingWithoutDriving) {
  SceneDescription description = described("laboratory");
  description.driving = false;
  description.objects.push_back(placed("bookshelf", "shelf", 0.0, 1.25));
  expectRefused(description, {"shelf", "master system", "its start"});
}

TEST(Refused, BlocksWhereTheyCannotBe) {
  ObjectPlacement block = placed("block", "fourth block", 2.0, 2.0);
  block.place.y_nm = -1'000'000'000;
  expectRefused(block, {"fourth block", "floor", "1027.5 mm"});
  block.place = basePose(0.0, 1.25, 0.0);
  block.place.y_nm = 600'000'000;
  expectRefused(block, {"fourth block", "master system", "its start"});
  block.place = basePose(0.4, -1.2, 0.0);
  block.place.y_nm = 720'000'000;
  expectRefused(block, {"fourth block", "table", "raise it by 27.5 mm"});
}

TEST(Refused, PlacesToScatterWithoutRoom) {
  SceneDescription description = described("laboratory");
  for (const ScatterArea& area :
       {ScatterArea{5e8, 5e8 + 1, 0, 1}, ScatterArea{-3.6, -3.5, 0, 1}, ScatterArea{0, 0.01, -1.2, -1.19}}) {
    description.scatter = area;
    expectRefused(description, {"scatter", "room", "block'"});
  }
  description.scatter.reset();
  expectRefused(description, {"laboratory", "scatter = [", "seed 7"}, 7);
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
