// What levels of detail save: a thousand cylinders and ellipsoids 1 to 50 m away, drawn with several budgets
// in turn, headless.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/scene/Primitives.h"
#include "render_client/draw/Renderer.h"
#include "render_client/present/Display.h"

namespace {

using namespace coherency;

/// As many of each a metre of distance: `sides` around, 0.1 to 0.6 m across, in view.
class Things : public VRObject {
 public:
  Things(int count, int sides, bool moving) : VRObject("things") {
    std::mt19937 engine(1);
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine()) / 0x1p32;
    };
    for (int i = 0; i < count; ++i) {
      const double away = 1.0 + 49.0 * i / count;
      const double radius = between(0.05, 0.3);
      if (i % 2 == 0)
        things_.push_back(std::make_unique<Cylinder>(radius, 2.0 * radius, sides));
      else
        things_.push_back(std::make_unique<Ellipsoid>(Coord3{radius, 0.7 * radius, radius}, sides));
      Polyhedron& thing = *things_.back();
      thing.setPosition(away * between(-0.9, 0.9), away * between(-0.6, 0.6), -away);
      thing.setColour(between(0.2, 0.9), between(0.2, 0.9), between(0.2, 0.9));
      if (moving) thing.attach(Moving{});
      addMember(&thing);
    }
  }

 private:
  std::vector<std::unique_ptr<Polyhedron>> things_;
};

/// An eye at the origin, with 90 degrees across.
EyeView lookAhead(int width, int height) {
  EyeView view;
  view.view = {1.0, 1.0, static_cast<double>(height) / width, static_cast<double>(height) / width};
  view.width = width;
  view.height = height;
  view.cyclopean = CyclopeanEye{{}, 0.032, 0.5 * width};
  return view;
}

/// Of all threads' processor time, for one frame.
double milliseconds(Renderer& renderer, Display& display, const EyeView& view) {
  const std::clock_t clock = std::clock();
  renderer.draw({&view, 1});
  display.present();
  return 1e3 * static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times pictures with several budgets for detail in turn, headless.", "bench_detail");
  DisplayConfig config;
  std::vector<double> budgets{0.0, 0.25, 0.5, 1.0};
  int count = 1000;
  int sides = 24;
  int frames = 100;
  bool moving = false;
  app.add_option("--detail-px", budgets, "How far curved things may be drawn off, pixels; 0,...")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--count", count, "Of things")->capture_default_str();
  app.add_option("--sides", sides, "Of each: a multiple of four")->capture_default_str();
  app.add_flag("--moving", moving, "They could move, and do not");
  app.add_option("--width", config.width, "Pixels")->capture_default_str();
  app.add_option("--height", config.height, "Pixels")->capture_default_str();
  app.add_option("--frames", frames, "Of each budget")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const auto display = makeHeadlessDisplay(config);
  const Things things(count, sides, moving);
  const EyeView view = lookAhead(config.width, config.height);
  const Illumination light{{}, {{0.6, 0.6, 0.6}, {0.2, 0.2, 0.2}}};
  std::vector<std::unique_ptr<Renderer>> renderers;
  renderers.reserve(budgets.size());
  for (const double detail_px : budgets)
    renderers.push_back(std::make_unique<Renderer>(things, light, config.width, config.height,
                                                   RendererSettings{.detail_px = detail_px}));
  std::vector<std::vector<double>> times(budgets.size());
  for (int frame = -3; frame < frames; ++frame)
    for (std::size_t i = 0; i < budgets.size(); ++i) {
      const double time = milliseconds(*renderers[i], *display, view);
      if (frame >= 0) times[i].push_back(time);
    }
  for (std::size_t i = 0; i < budgets.size(); ++i) {
    std::sort(times[i].begin(), times[i].end());
    const auto at = [&](double share) { return times[i][static_cast<std::size_t>(share * (frames - 1))]; };
    std::printf("%5.2f px  %7zu triangles  %6.2f ms of processor (quartiles %.2f, %.2f)\n", budgets[i],
                renderers[i]->counts().triangles, at(0.5), at(0.25), at(0.75));
  }
  std::printf("%s, %zu triangles in all\n", renderers[0]->rendererName().c_str(),
              renderers[0]->triangleCount());
  return 0;
}
