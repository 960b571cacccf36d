// Draws one picture of a scene: for those who write scenes, and for those who want to see what a posture
// looks like.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

#include <CLI/CLI.hpp>

#include "common/config/RigFile.h"
#include "common/config/SceneFile.h"
#include "common/math/FixedPoint.h"
#include "common/motion/SampleGate.h"
#include "common/world/Scene.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/draw/PictureSize.h"
#include "render_client/draw/Renderer.h"
#include "render_client/present/Display.h"
#include "render_client/present/Png.h"

namespace {

using namespace coherency;

constexpr double kDegree = std::numbers::pi / 180.0;

struct Options {
  std::string scene;
  std::string file;
  std::string eye = "both";
  std::string size = "640x480";
  std::vector<double> head;
  std::vector<double> base;
  std::vector<double> robot_base;
  std::vector<double> doors;
  bool robot_mode = false;
  bool hold = false;
  std::string scenes = "configs/scenes";
  std::string rig;
  std::vector<double> camera;
  std::vector<std::string> set;
  double fov_deg = 90.0;
  std::string hmd;
  RendererSettings renderer;
  bool no_shadows = false;
};

void addOptions(CLI::App& app, Options& o) {
  app.add_option("scene", o.scene, "Scene's name or TOML file")->required();
  app.add_option("picture", o.file, "PNG file to write")->required();
  app.add_option("--eye", o.eye, "Eye to look through; both: side by side")
      ->check(CLI::IsMember({"left", "right", "mono", "both"}))
      ->capture_default_str();
  app.add_option("--size", o.size, "Width x height of one eye's picture, pixels")->capture_default_str();
  app.add_option("--fov", o.fov_deg, "Horizontal field of view, degrees")
      ->check(CLI::Range(1.0, 170.0))
      ->capture_default_str();
  app.add_option("--hmd", o.hmd,
                 "HMD profile in place of --fov; the picture is what its panels show, --size theirs");
  app.add_option("--head", o.head, "x,y,z,yaw,pitch,roll of the head in the body frame (m, rad)")
      ->delimiter(',')
      ->expected(6);
  app.add_option("--base", o.base,
                 "x,z,heading of the operator's base (m, degrees; default: the scene's workplace)")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--robot-base", o.robot_base,
                 "The same for the robot (default: its start; with --robot its workplace)")
      ->delimiter(',')
      ->expected(3);
  app.add_flag("--robot", o.robot_mode, "Look through the robot's cameras");
  app.add_flag("--hold", o.hold,
               "The right hand holds the scene's first movable, best placed (robot's with --robot)");
  app.add_option("--doors", o.doors, "How far each door is open, 0 to 1, in the scene's order")
      ->delimiter(',');
  app.add_option("--scenes", o.scenes, "Folder of the scenes that are called by name")->capture_default_str();
  app.add_option("--rig", o.rig, "TOML file of the operator's measures (default: the default rig)");
  app.add_option("--set", o.set, "dof=value in SI units, such as grip=1; may be repeated");
  app.add_option("--camera", o.camera, "x,y,z,yaw,pitch in the world (m, degrees), in place of an eye")
      ->delimiter(',')
      ->expected(5);
  app.add_option("--samples", o.renderer.samples, "Antialiasing samples a pixel")->capture_default_str();
  app.add_option("--shadow-resolution", o.renderer.shadow_resolution, "Shadow map's texels a side")
      ->capture_default_str();
  app.add_option("--rays", o.renderer.bake.rays, "Rays a vertex for the light of what never moves")
      ->capture_default_str();
  app.add_option("--tolerance", o.renderer.bake.tolerance, "Of that light between vertices (BakeSettings)")
      ->capture_default_str();
  app.add_option("--finest", o.renderer.bake.finest, "Edges as short are not cut for that light, m")
      ->capture_default_str();
  app.add_flag("--no-shadows", o.no_shadows, "Draw without shadows");
}

void setDof(std::array<double, kDofCount>& si, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::optional<Dof> dof = dofByName(assignment.substr(0, equals));
  if (equals == std::string::npos || !dof)
    throw std::invalid_argument("--set " + assignment + ": must be dof=value with one of the 19 DOFs' names");
  si[index(*dof)] = std::stod(assignment.substr(equals + 1));
}

MotionSample makeSample(const Options& o, const Rig& rig) {
  MasterReading reading;
  reading.si = neutralPosture(rig);
  std::copy(o.head.begin(), o.head.end(), reading.si.begin());
  for (const std::string& assignment : o.set) setDof(reading.si, assignment);
  const MotionSample sample = SampleGate(neutralPosture(rig)).admit(reading, 1, 0);
  for (std::size_t i = 0; i < kDofCount; ++i)
    if (!sample.isValid(dofAt(i))) {
      const DofInfo& dof = info(dofAt(i));
      std::ostringstream text;
      text << dof.name << " = " << reading.si[i] << " must be " << dof.min << " to " << dof.max;
      throw std::invalid_argument(text.str());
    }
  return sample;
}

BasePose makeBase(const std::vector<double>& given, const BasePose& otherwise) {
  return given.empty() ? otherwise : basePose(given[0], given[1], given[2] * kDegree);
}

/// As when the hand had closed upon it just where it should, faces along the hand's axes.
void putInHand(const Options& o, const Scene& scene, WorldState& state) {
  if (state.movables.empty()) throw std::invalid_argument("--hold: the scene has nothing to hold");
  Movable& held = state.movables.front();
  held.holder = o.robot_mode ? Holder::RobotHand : Holder::OperatorHand;
  const Coord3 at = scene.world().hand(held.holder).graspPoint();
  held.x_nm = nanometresFromMetres(at.x);
  held.y_nm = nanometresFromMetres(at.y);
  held.z_nm = nanometresFromMetres(at.z);
  setAttitude(held, quaternion(TransformMatrix{}));
}

WorldState makeState(const Options& o, const Scene& scene) {
  WorldState state = scene.initialState();
  state.mode = o.robot_mode ? Mode::Robot : Mode::Operator;
  const SceneDescription& description = scene.description();
  state.master.base = makeBase(o.base, o.robot_mode ? description.start : description.workplace);
  if (!scene.world().has(state.mode)) throw std::invalid_argument("--robot: the scene has no robot");
  if (description.robot)
    state.robot.base =
        makeBase(o.robot_base, o.robot_mode ? description.robot->workplace : description.robot->start);
  for (std::size_t i = 0; i < o.doors.size() && i < state.doors.size(); ++i)
    state.doors[i] = unitsFromRatio(std::clamp(o.doors[i], 0.0, 1.0));
  if (o.hold) putInHand(o, scene, state);
  return state;
}

/// Through a profile's displays, and what is then on their panels.
Image panels(const Options& o, const Scene& scene, const PanelSize& size) {
  const HmdProfile hmd = readHmdProfile(o.hmd);
  const EyeChoice eyes = eyeChoice(o.eye);
  const PanelSize picture = pictureSize(hmd, eyes, size.width, size.height, 1.0);
  std::vector<EyeView> views;
  eyeViews(scene, o.robot_mode ? Mode::Robot : Mode::Operator, hmd, eyes, picture.width, picture.height,
           views);
  Renderer renderer(scene, picture.width * eyeCount(eyes), picture.height, o.renderer);
  renderer.setDisplay(hmd, eyes);
  renderer.draw(views);
  return renderer.readPanel(size.width * eyeCount(eyes), size.height);
}

std::vector<EyeView> makeViews(const Options& o, const Scene& scene, int width, int height) {
  const double tan_h = std::tan(0.5 * o.fov_deg * kDegree);
  const double tan_v = tan_h * height / width;
  const FieldOfView view{tan_h, tan_h, tan_v, tan_v};
  const Mode mode = o.robot_mode ? Mode::Robot : Mode::Operator;
  const auto through = [&](Eye eye, int x) {
    return EyeView{scene.eye(eye, mode).globalTransform(),
                   view,
                   0.01,
                   x,
                   0,
                   width,
                   height,
                   vehicle(scene, mode),
                   otherVehicle(scene, mode)};
  };
  if (!o.camera.empty()) {
    const TransformMatrix at = TransformMatrix::translation({o.camera[0], o.camera[1], o.camera[2]}) *
                               rotation(YawPitchRoll{o.camera[3] * kDegree, o.camera[4] * kDegree, 0.0});
    return {EyeView{at, view, 0.01, 0, 0, width, height, vehicle(scene, mode), otherVehicle(scene, mode)}};
  }
  if (o.eye == "both") return {through(Eye::Left, 0), through(Eye::Right, width)};
  return {through(o.eye == "left" ? Eye::Left : (o.eye == "right" ? Eye::Right : Eye::Mono), 0)};
}

void look(Options& o) {
  DisplayConfig config;
  char rest = 0;
  if (std::sscanf(o.size.c_str(), "%dx%d%c", &config.width, &config.height, &rest) != 2 || config.width < 1 ||
      config.height < 1)
    throw std::invalid_argument("--size " + o.size + ": must be WIDTHxHEIGHT, such as 640x480");
  const Rig rig = o.rig.empty() ? Rig{} : readRig(o.rig);
  const auto scene = std::make_unique<Scene>(readScene(o.scene, o.scenes), rig);
  const WorldState state = makeState(o, *scene);
  scene->apply(state, makeSample(o, rig));

  const std::unique_ptr<Display> display = makeHeadlessDisplay(config);
  o.renderer.shadows = !o.no_shadows;
  if (!o.hmd.empty()) {
    writePng(o.file, panels(o, *scene, {config.width, config.height}), {{"scene", o.scene}, {"hmd", o.hmd}});
    return;
  }
  const std::vector<EyeView> views = makeViews(o, *scene, config.width, config.height);
  Renderer renderer(*scene, config.width * static_cast<int>(views.size()), config.height, o.renderer);
  renderer.draw(views);
  writePng(o.file, renderer.readImage(), {{"scene", o.scene}, {"renderer", renderer.rendererName()}});
  std::printf("%s: %zu objects, %zu polygons, %zu triangles, %zu vertices, %d samples, %s\n", o.file.c_str(),
              renderer.report().objects(), scene->polygonCount(), renderer.triangleCount(),
              renderer.vertexCount(), renderer.samples(), renderer.rendererName().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws one picture of a scene, without window or server.", "look");
  Options options;
  addOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    look(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "look: %s\n", error.what());
    return 1;
  }
  return 0;
}
