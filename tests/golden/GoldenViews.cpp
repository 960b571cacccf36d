#include "tests/golden/GoldenViews.h"

#include <algorithm>
#include <stdexcept>

#include "common/config/SceneFile.h"
#include "common/math/FixedPoint.h"
#include "common/motion/SampleGate.h"

namespace coherency::golden {
namespace {

constexpr double kDegree = kTurn / 360.0;

MotionSample sampleOf(const GoldenView& view) {
  MasterReading reading;
  reading.si = neutralPosture(Rig{});
  for (const auto& [dof, by] : view.posture) reading.si[index(dof)] += by;
  const MotionSample sample = SampleGate(neutralPosture(Rig{})).admit(reading, 1, 0);
  for (const auto& [dof, by] : view.posture)
    if (!sample.isValid(dof))
      throw std::invalid_argument("golden view " + view.name + ": " + std::string(info(dof).name) +
                                  " is out of range");
  return sample;
}

/// As when the hand had closed upon it just where it should.
void putInHand(const Scene& scene, WorldState& state) {
  Movable& held = state.movables.front();
  held.holder = state.mode == Mode::Robot ? Holder::RobotHand : Holder::OperatorHand;
  const Coord3 at = scene.world().hand(held.holder).graspPoint();
  held.x_nm = nanometresFromMetres(at.x);
  held.y_nm = nanometresFromMetres(at.y);
  held.z_nm = nanometresFromMetres(at.z);
  setAttitude(held, quaternion(TransformMatrix{}));
}

}  // namespace

const std::vector<GoldenView>& goldenViews() {
  static const BasePose kAtTable = basePose(0.0, -0.44, 0.0);
  static const BasePose kAside = basePose(2.4, 2.2, 0.0);
  static const std::vector<GoldenView> kViews = {
      {.name = "operator_at_table",
       .scene = "laboratory",
       .eyes = EyeChoice::Both,
       .master = kAtTable,
       .posture = {{Dof::HeadPitch, -0.35}, {Dof::ShoulderFlexion, 0.3}}},
      {.name = "robot_at_table",
       .scene = "laboratory",
       .mode = Mode::Robot,
       .eyes = EyeChoice::Both,
       .master = kAside,
       .posture = {{Dof::HeadPitch, -0.45}, {Dof::ShoulderFlexion, 0.45}, {Dof::Grip, 1.0}},
       .holds = true},
      {.name = "own_body",
       .scene = "laboratory",
       .eyes = EyeChoice::Left,
       .master = kAtTable,
       .posture = {{Dof::HeadPitch, -1.0}}},
      {.name = "laboratory",
       .scene = "laboratory",
       .master = kAtTable,
       .camera = {2.8, 1.7, -2.2, 115.0, -12.0}},
      {.name = "door_open",
       .scene = "laboratory",
       .master = kAtTable,
       .doors = 0.8,
       .camera = {5.0, 1.4, -0.2, 130.0, -6.0}},
      {.name = "door_shut",
       .scene = "laboratory",
       .master = kAtTable,
       .camera = {5.0, 1.4, -0.2, 130.0, -6.0}},
      {.name = "office", .scene = "laboratory", .master = kAtTable, .camera = {6.5, 1.6, 2.3, -45.0, -12.0}},
      {.name = "from_outdoors",
       .scene = "laboratory",
       .master = kAtTable,
       .camera = {0.0, 1.6, -9.0, 180.0, 0.0}},
      {.name = "corridor", .scene = "corridor"},
      {.name = "blocks_on_desk",
       .scene = "blocks",
       .eyes = EyeChoice::Both,
       .hmd = "desk",
       .master = kAtTable,
       .posture = {{Dof::HeadX, 0.05}}},
      {.name = "look", .scene = "look", .hmd = "wide"},
      {.name = "targets", .scene = "targets", .eyes = EyeChoice::Both, .hmd = "vive"},
      {.name = "grid", .scene = "grid:1000", .hmd = "wide"}};
  return kViews;
}

std::vector<std::string> goldenScenes() {
  std::vector<std::string> scenes;
  for (const GoldenView& view : goldenViews())
    if (std::find(scenes.begin(), scenes.end(), view.scene) == scenes.end()) scenes.push_back(view.scene);
  return scenes;
}

std::unique_ptr<Scene> makeScene(const std::string& name) {
  return std::make_unique<Scene>(readScene(name, COHERENCY_CONFIGS "/scenes"), Rig{});
}

GoldenPicture draw(Renderer& renderer, Scene& scene, const GoldenView& view) {
  WorldState state = scene.initialState();
  state.mode = view.mode;
  if (view.master) state.master.base = *view.master;
  if (view.mode == Mode::Robot) state.robot.base = scene.workplace(Mode::Robot);
  for (std::int32_t& door : state.doors) door = unitsFromRatio(view.doors);
  if (view.holds) putInHand(scene, state);
  scene.apply(state, sampleOf(view));
  std::vector<EyeView> views;
  eyeViews(scene, view.mode, readHmdProfile(COHERENCY_CONFIGS "/hmds/" + view.hmd + ".toml"), view.eyes,
           kWidth, kHeight, views);
  if (!view.camera.empty())
    views.front().t_world_eye =
        TransformMatrix::translation({view.camera[0], view.camera[1], view.camera[2]}) *
        rotation(YawPitchRoll{view.camera[3] * kDegree, view.camera[4] * kDegree, 0.0});
  renderer.resize(eyeCount(view.eyes) * kWidth, kHeight);
  renderer.draw(views);
  return goldenPicture(renderer.readImage(), renderer.drawIds(views), scene);
}

}  // namespace coherency::golden
