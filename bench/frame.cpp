// What an eye's picture costs: time from the start to the first frame, and of a frame, in views where one
// works and where one looks about. Headless, so on a machine without a GPU the software renderer's time is in
// it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/body/Posture.h"
#include "common/config/SceneFile.h"
#include "common/motion/SampleGate.h"
#include "common/world/Scene.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/draw/PictureSize.h"
#include "render_client/draw/Renderer.h"
#include "render_client/present/Display.h"

namespace {

using namespace coherency;
using Steady = std::chrono::steady_clock;

double millisecondsSince(Steady::time_point begin) {
  return std::chrono::duration<double, std::milli>(Steady::now() - begin).count();
}

/// A head turned to the left and bowed, at the scene's workplace or at its start; radians.
struct Look {
  const char* name;
  bool working;
  double yaw;
  double pitch;
};
constexpr Look kLooks[] = {
    {"at work", true, 0.0, -0.5}, {"ahead", true, 0.0, 0.0}, {"about", false, 0.6, -0.2}};

void pose(Scene& scene, const Look& look) {
  const Rig& rig = scene.human().rig();
  MasterReading reading;
  reading.si = neutralPosture(rig);
  reading.si[index(Dof::HeadYaw)] = look.yaw;
  reading.si[index(Dof::HeadPitch)] = look.pitch;
  WorldState state = scene.initialState();
  state.master.base = look.working ? scene.description().workplace : scene.description().start;
  scene.apply(state, SampleGate(neutralPosture(rig)).admit(reading, 1, 0));
}

/// Of the middle one of many frames, ms.
struct FrameTime {
  double wall;
  double processor;  ///< of all threads together: says more than `wall` where others use the machine too
};

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

FrameTime timeOf(int times, const auto& action) {
  std::vector<double> wall;
  std::vector<double> processor;
  for (int i = 0; i < times; ++i) {
    const auto begin = Steady::now();
    const std::clock_t clock = std::clock();
    action();
    wall.push_back(millisecondsSince(begin));
    processor.push_back(1e3 * static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
  }
  return {median(wall), median(processor)};
}

FrameTime timeFrames(Renderer& renderer, Display& display, const std::vector<EyeView>& views, int frames) {
  return timeOf(frames, [&] {
    renderer.draw(views);
    display.present();
  });
}

/// Of what a lens adds to a picture that is drawn already. Both are read back, so that the GPU is waited for.
void timeLens(Renderer& renderer, const DisplayConfig& panel, const PanelSize& picture, int frames) {
  renderer.readImage();  // resolves
  const FrameTime plain = timeOf(frames, [&] { renderer.readImage(); });
  const FrameTime bent = timeOf(frames, [&] { renderer.readPanel(panel.width, panel.height); });
  std::printf(
      "picture of %dx%d pixels: read in %.2f ms; panel of %dx%d: made for its lens and read in %.2f ms\n",
      picture.width, picture.height, plain.wall, panel.width, panel.height, bent.wall);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the pictures of one eye, headless.", "bench_frame");
  std::string name = "laboratory";
  std::string folder = "configs/scenes";
  DisplayConfig config;
  RendererSettings settings;
  int frames = 60;
  std::string profile;
  bool explain = false;
  app.add_option("scene", name, "Scene's name or TOML file")->capture_default_str();
  app.add_option("--scenes", folder, "Folder of the scenes that are called by name")->capture_default_str();
  app.add_option("--width", config.width, "Pixels")->capture_default_str();
  app.add_option("--height", config.height, "Pixels")->capture_default_str();
  app.add_option("--hmd", profile, "HMD profile; width and height are then its panel's, if it has one");
  app.add_option("--frames", frames, "Of each view")->capture_default_str();
  app.add_option("--samples", settings.samples, "Antialiasing samples a pixel")->capture_default_str();
  app.add_option("--rays", settings.bake.rays, "Rays a vertex for the light of what never moves")
      ->capture_default_str();
  app.add_flag("--no-clipping{false}", settings.clip, "Draw what is out of view, too");
  app.add_option("--tolerance", settings.bake.tolerance, "Of that light between vertices (BakeSettings)")
      ->capture_default_str();
  app.add_option("--finest", settings.bake.finest, "Edges as short are not cut for that light, m")
      ->capture_default_str();
  app.add_option("--detail-px", settings.detail_px, "How far curved things may be drawn off, pixels; 0: none")
      ->capture_default_str();
  app.add_option("--smallest-px", settings.smallest_px,
                 "What is smaller across is left out, pixels; 0: nothing")
      ->capture_default_str();
  app.add_flag("--no-shadows{false}", settings.shadows, "Draw without shadows");
  app.add_flag("--explain", explain, "Print what was compiled, what was left out and why, and what it takes");
  CLI11_PARSE(app, argc, argv);

  const HmdProfile hmd = profile.empty() ? HmdProfile{} : readHmdProfile(profile);
  if (hmd.panel) {
    config.width = hmd.panel->width;
    config.height = hmd.panel->height;
  }
  const PanelSize picture = pictureSize(hmd, EyeChoice::Left, config.width, config.height, 1.0);
  const auto display = makeHeadlessDisplay(config);
  const auto scene = std::make_unique<Scene>(readScene(name, folder), Rig{});
  const auto begin = Steady::now();
  Renderer renderer(*scene, picture.width, picture.height, settings);
  renderer.setDisplay(hmd, EyeChoice::Left);
  std::printf("renderer made in %.0f ms, %zu polygons, %zu triangles, %zu vertices, %.2f MiB, %s\n",
              millisecondsSince(begin), scene->polygonCount(), renderer.triangleCount(),
              renderer.vertexCount(), static_cast<double>(renderer.report().bytes) / (1 << 20),
              renderer.rendererName().c_str());
  if (explain) std::fputs(renderer.explain().c_str(), stdout);
  for (const Look& look : kLooks) {
    pose(*scene, look);
    std::vector<EyeView> views;
    eyeViews(*scene, Mode::Operator, hmd, EyeChoice::Left, picture.width, picture.height, views);
    timeFrames(renderer, *display, views, 3);
    const FrameTime time = timeFrames(renderer, *display, views, frames);
    const FrameCounts counts = renderer.counts();
    std::printf(
        "%-8s %6.2f ms a frame, %6.2f ms of processor; %zu move, %zu near them, %zu others, %zu triangles\n",
        look.name, time.wall, time.processor, counts.moving, counts.fixed_shaded, counts.fixed_plain,
        counts.triangles);
  }
  if (hasLens(hmd, EyeChoice::Left)) timeLens(renderer, config, picture, frames);
  return 0;
}
