// The worlds one can be in: what is in them, how much of it, and that it stands where it says.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "common/objects/Targets.h"
#include "common/scene/Light.h"
#include "common/scene/Senses.h"
#include "common/world/Catalogue.h"
#include "tests/scenes/Coplanar.h"
#include "tests/scenes/Support.h"

namespace coherency {
namespace {

using namespace scenes;

/// Of what a scene's file names: everything but the vehicles.
struct Amount {
  std::size_t polygons = 0;
  std::size_t drawn = 0;
};

Amount furnished(const Scene& scene) {
  Amount amount;
  for (const VRObject* member : scene.members()) {
    if (member == &scene.human() || member == scene.robot()) continue;
    amount.polygons += member->polygonCount();
    forEachDrawn(*member, "", [&](const VRObject&, const TransformMatrix&) { ++amount.drawn; });
  }
  return amount;
}

TEST(Scenes, AllThatAreShippedStandAndAllInThemIsNamed) {
  for (const std::string& name : kShipped) {
    const Scene scene(described(name), Rig{});
    EXPECT_EQ(scene.name(), name);
    EXPECT_GT(scene.polygonCount(), 0U) << name;
    forEachObject(scene, {}, [](const VRObject& object, const TransformMatrix&) {
      EXPECT_FALSE(object.name().empty()) << object.path();
    });
  }
}

TEST(Scenes, ApplyPutsTheHumanOnItsBase) {
  Scene scene(described("laboratory"), Rig{});
  WorldState state = scene.initialState();
  state.master.base.x_nm = 1'234'567'890;
  state.master.base.heading_units = 1 << 30;  // a quarter turn to the left: ahead is -x
  scene.apply(state, neutralSample(Rig{}));
  const TransformMatrix t_world_body = scene.human().globalTransform();
  EXPECT_NEAR(t_world_body.origin().x, 1.23456789, 1e-12);
  EXPECT_NEAR(norm(t_world_body.vector({0.0, 0.0, -1.0}) - Coord3{-1.0, 0.0, 0.0}), 0.0, 1e-12);
}

/// Bodies are other tests' matter.
bool isVehicle(const std::string& path) {
  return path.find("/virtual human/") != std::string::npos || path.find("/slave robot/") != std::string::npos;
}

TEST(Scenes, ShowNoTwoFacesInOnePlace) {
  for (const std::string& name : kShipped) {
    Scene scene(described(name), Rig{});
    WorldState state = scene.initialState();
    for (const double open : {0.0, 0.5, 1.0}) {
      for (std::int32_t& door : state.doors) door = static_cast<std::int32_t>(open * kDoorOpen);
      scene.apply(state, neutralSample(Rig{}));
      for (const Fight& fight : coplanarFaces(scene)) {
        if (isVehicle(fight.one) && isVehicle(fight.other)) continue;
        ADD_FAILURE() << fight.one << " and " << fight.other << " share " << fight.area * 1e4
                      << " cm2 about x " << fight.at.x << ", y " << fight.at.y << ", z " << fight.at.z;
      }
      if (state.doors.empty()) break;
    }
  }
}

TEST(Coplanar, FacesAreFoundThatFightAndNoOthers) {
  VRObject root("root");
  Box table({1.0, 0.1, 1.0}, "table");
  Box sheet({0.2, 0.1, 0.2}, "sheet");
  root.addMember(&table);
  root.addMember(&sheet);
  sheet.setPosition(0.0, 0.0003, 0.0);  // its top is as good as in the table's, and so is its bottom
  EXPECT_EQ(coplanarFaces(root).size(), 2U);
  EXPECT_NEAR(coplanarFaces(root).front().area, 0.04, 1e-9);
  sheet.setPosition(0.0, 0.0006, 0.0);
  EXPECT_TRUE(coplanarFaces(root).empty());
  sheet.setPosition(0.0, 0.1, 0.0);  // stands on it: the two face each other
  EXPECT_TRUE(coplanarFaces(root).empty());
  sheet.setPosition(0.6, 0.0, 0.0);  // beside it
  EXPECT_TRUE(coplanarFaces(root).empty());
}

TEST(Building, DoorsAndWindowsHaveThePapersPolygons) {
  const Scene scene(described("laboratory"), Rig{});
  const auto doors = called(scene, "door");
  const auto windows = called(scene, "window");
  EXPECT_EQ(doors.size(), scene.world().model().doors.size());
  EXPECT_EQ(doors.size(), 3U);
  EXPECT_GE(windows.size(), 3U);
  for (const VRObject* door : doors) EXPECT_EQ(door->polygonCount(), 122U) << door->path();
  for (const VRObject* window : windows) EXPECT_EQ(window->polygonCount(), 30U) << window->path();
}

TEST(Building, KeepsWithinItsBudget) {
  const Amount amount = furnished(Scene(described("laboratory"), Rig{}));
  EXPECT_LE(amount.polygons, 11'000U) << "20 000 with the vehicles";
  EXPECT_LE(amount.drawn, 700U);
}

/// What a point that looks up gets from the lamps that nothing shades, in units of white's full brightness.
double irradiance(const Scene& scene, const Coord3& at) {
  double sum = 0.0;
  for (const Light& light : scene.lights()) {
    const Coord3 way = light.position - at;
    if (norm(way) > 4.0 || way.y <= 0.0) continue;  // farther ones stand in other rooms
    sum += light.intensity * way.y / std::pow(norm(way), 3.0);
  }
  return sum;
}

TEST(Building, EveryRoomIsLit) {
  const Scene scene(described("laboratory"), Rig{});
  const std::vector<Coord3> places = {{0.0, 0.72, -1.2}, {2.0, 0.0, 1.0},  {4.76, 0.0, -6.0},
                                      {4.76, 0.0, 6.0},  {8.31, 0.0, 0.0}, {9.9, 0.74, 1.0},
                                      {0.0, 0.74, 6.2}};
  for (const Coord3& place : places) {
    EXPECT_GT(irradiance(scene, place), 0.35) << "x " << place.x << ", z " << place.z;
    EXPECT_LT(irradiance(scene, place), 1.1) << "x " << place.x << ", z " << place.z;
  }
}

TEST(Building, IsHeardAndFelt) {
  const Scene scene(described("laboratory"), Rig{});
  std::size_t sounds = 0;
  forEachObject(scene, {}, [&](const VRObject& object, const TransformMatrix&) {
    sounds += object.attribute<SoundSource>() != nullptr;
    if (const auto* surface = object.attribute<Surface>(); surface != nullptr) {
      EXPECT_FALSE(surface->material.empty()) << object.path();
      EXPECT_GT(surface->stiffness_n_m, 0.0) << object.path();
    }
  });
  EXPECT_GE(sounds, 8U);
  for (const char* name : {"table", "desk", "rack", "front wall", "plant leaves", "chair seat"})
    EXPECT_NE(called(scene, name).at(0)->attribute<Surface>(), nullptr) << name;
}

TEST(Catalogue, EachKindCanBeMadeByItself) {
  const Rig rig;
  VirtualHuman human(rig, HumanShown::None);
  Stage stage{rig, human};
  for (const CatalogueEntry& entry : catalogue()) {
    ObjectPlacement placement;
    placement.kind = entry.kind;
    placement.name = "one";
    placement.count = entry.counted ? 9 : 0;
    const auto object = makeObject(placement, stage);
    EXPECT_GT(object->polygonCount(), 0U) << entry.kind;
    EXPECT_EQ(object->name(), "one");
    EXPECT_FALSE(entry.what.empty());
  }
}

TEST(Grid, HasAsManyBoxesAsOneAsksForNoneInAnother) {
  const Scene scene(described("grid:10000"), Rig{});
  EXPECT_EQ(furnished(scene).drawn, 10'000U);
  const Scene few(described("grid:50"), Rig{});
  std::vector<Extent> boxes;
  forEachDrawn(few, "box ", [&](const VRObject& box, const TransformMatrix& t_world_box) {
    boxes.emplace_back();
    for (const Coord3& v : box.faces()->vertices) boxes.back().add(t_world_box.point(v));
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_LT(boxes[i].high.z, 0.0) << "ahead";
    EXPECT_NEAR(boxes[i].low.y, 0.0, 1e-9) << "on the floor";
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_TRUE(boxes[i].low.x > boxes[k].high.x || boxes[k].low.x > boxes[i].high.x ||
                  boxes[i].low.z > boxes[k].high.z || boxes[k].low.z > boxes[i].high.z);
  }
}

TEST(TargetsScene, StandsWhereItSays) {
  const Rig rig;
  Scene scene(described("targets"), rig);
  scene.apply(scene.initialState(), neutralSample(rig));
  const Coord3 eyes = scene.human().eye(Eye::Mono).globalTransform().origin();
  const std::array<const char*, 3> names = {"red at 0.5 m", "yellow at 1 m", "cyan at 5 m"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Extent ball = extentOf(scene, names[i]);
    EXPECT_NEAR(eyes.z - ball.middle().z, Targets::kDistances[i], 1e-6) << names[i];
    EXPECT_NEAR(ball.middle().x, eyes.x, 1e-6);
    EXPECT_NEAR(ball.high.y - ball.low.y, 2.0 * Targets::kAngularRadius * Targets::kDistances[i], 1e-9);
  }
  const Posture& p = scene.human().posture();
  const Coord3 wrist = (p.t_body_shoulder * p.right_arm.t_shoulder_hand).origin();
  EXPECT_NEAR(norm(extentOf(scene, "magenta").middle() - wrist), 0.0, 1e-9);
  EXPECT_NEAR(norm(extentOf(scene, "green at the palm").middle() - p.t_body_shoulder.point(p.right_arm.palm)),
              0.0, 1e-9);
}

}  // namespace
}  // namespace coherency
