// What baking a scene's light costs, and how far off it is with fewer rays: against 1024 rays a vertex, in
// what is shown.
#include "render_client/compile/Bake.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <tuple>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include "common/config/SceneFile.h"
#include "common/world/Scene.h"
#include "render_client/compile/FixedSurface.h"
#include "render_client/compile/ToneCurve.h"

namespace {

using namespace coherency;
using Steady = std::chrono::steady_clock;

constexpr int kTruth = 1024;

void addFixed(const VRObject& object, const TransformMatrix& t_world_parent, FixedMesh& mesh) {
  if (object.attribute<Moving>() != nullptr) return;
  const TransformMatrix t_world_object = t_world_parent * object.transform();
  mesh.add(object, t_world_object);
  for (const VRObject* member : object.members()) addFixed(*member, t_world_object, mesh);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Leaves the last one's mesh and light.
Bake timeBakes(const FixedMesh& shapes, const Illumination& illumination, const BakeSettings& settings,
               int runs, FixedMesh& mesh) {
  std::vector<double> wall;
  std::vector<double> processor;
  Bake baked;
  for (int run = 0; run < runs; ++run) {
    mesh = shapes;
    const auto begin = Steady::now();
    const std::clock_t clock = std::clock();
    baked = bake(mesh, illumination, settings);
    wall.push_back(std::chrono::duration<double, std::milli>(Steady::now() - begin).count());
    processor.push_back(1e3 * static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
  }
  std::printf(
      "%5d rays, tolerance %.3f, finest %.2f m: %7.1f ms, least %7.1f, %7.1f of processor, %zu vertices, %zu "
      "triangles",
      settings.rays, settings.tolerance, settings.finest, median(wall),
      *std::min_element(wall.begin(), wall.end()), median(processor), mesh.vertices.size(),
      mesh.indices.size() / 3);
  return baked;
}

/// Between vertices: in places spread evenly over all surfaces that are lit, as it is drawn.
void printErrorBetween(FixedMesh& mesh, const Bake& baked, const LightBaker& truth) {
  constexpr float kEach = 0.02F;  // m^2; one place for so much
  const FixedSurface surface(mesh);
  std::vector<double> errors;
  double sum = 0.0;
  float passed = 0.0F;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t* c = &mesh.indices[i];
    const FixedObject& object = mesh.objectOf(c[0]);
    if (object.object->faces()->material.emission >= 1.0 || !std::isfinite(object.longest_edge)) continue;
    const SurfacePoint corner[3] = {surface.at(c[0]), surface.at(c[1]), surface.at(c[2])};
    passed += 0.5F * glm::length(glm::cross(corner[1].position - corner[0].position,
                                            corner[2].position - corner[0].position));
    for (; passed > 0.0F; passed -= kEach) {
      // Roberts' R2 sequence, folded.
      const auto n = static_cast<double>(errors.size());
      double u = std::fmod(n * 0.7548776662466927, 1.0);
      double v = std::fmod(n * 0.5698402909980532, 1.0);
      if (u + v > 1.0) std::tie(u, v) = std::pair(1.0 - u, 1.0 - v);
      const float share[3] = {static_cast<float>(1.0 - u - v), static_cast<float>(u), static_cast<float>(v)};
      SurfacePoint at{glm::vec3(0.0F), glm::vec3(0.0F)};
      float drawn = 0.0F;
      for (std::size_t k = 0; k < 3; ++k) {
        at.position += share[k] * corner[k].position;
        at.normal += share[k] * corner[k].normal;
        drawn += share[k] * baked.light[c[k]].light.g;
      }
      at.normal = glm::normalize(at.normal);
      const SurfaceLight light = truth.light(at);
      const auto colour = static_cast<float>(object.object->faces()->material.colour.y);
      errors.push_back(light.buried
                           ? 0.0
                           : std::abs(encoded(tone(colour * drawn)) - encoded(tone(colour * light.light.g))));
      sum += errors.back();
    }
  }
  const auto at = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 99 / 100);
  std::nth_element(errors.begin(), at, errors.end());
  std::printf("; between vertices off by %.2f %% in the mean, %.2f %% at p99\n",
              100.0 * sum / static_cast<double>(errors.size()), 100.0 * *at);
}

std::vector<SurfaceLight> lightOf(const FixedSurface& surface, Illumination illumination, int rays) {
  for (Light& lamp : illumination.lamps) lamp.position -= surface.origin();
  const LightBaker baker(surface.occluders(), illumination, rays);
  std::vector<SurfaceLight> light;
  for (std::uint32_t v = 0; v < surface.mesh().vertices.size(); ++v)
    light.push_back(baker.light(surface.at(v)));
  return light;
}

/// Prints the mean and the 99th percentile over all vertices that are seen, as shares of a display's range.
void printError(const FixedMesh& mesh, const std::vector<SurfaceLight>& light,
                const std::vector<SurfaceLight>& truth) {
  std::vector<double> errors;
  double sum = 0.0;
  for (std::uint32_t v = 0; v < light.size(); ++v) {
    if (light[v].buried || truth[v].buried) continue;
    const Material& material = mesh.objectOf(v).object->faces()->material;
    const auto shown = [&](const SurfaceLight& l) {
      return encoded(tone(static_cast<float>(material.colour.y) * l.light.g));
    };
    errors.push_back(std::abs(shown(light[v]) - shown(truth[v])));
    sum += errors.back();
  }
  const auto at = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 99 / 100);
  std::nth_element(errors.begin(), at, errors.end());
  std::printf("; at vertices off by %.2f %% in the mean, %.2f %% at p99",
              100.0 * sum / static_cast<double>(errors.size()), 100.0 * *at);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the baking of a scene's light and measures its error.", "bench_bake");
  std::string name = "laboratory";
  std::string folder = "configs/scenes";
  int runs = 5;
  app.add_option("scene", name, "Scene's name or TOML file")->capture_default_str();
  app.add_option("--scenes", folder, "Folder of the scenes that are called by name")->capture_default_str();
  app.add_option("--runs", runs, "Of which the middle one is printed")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const auto scene = std::make_unique<Scene>(readScene(name, folder), Rig{});
  const Illumination illumination{scene->lights(), scene->ambient()};
  FixedMesh shapes;
  addFixed(*scene, {}, shapes);
  FixedMesh mesh = shapes;
  bake(mesh, illumination, {});
  const FixedSurface surface(mesh);
  const std::vector<SurfaceLight> truth = lightOf(surface, illumination, kTruth);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::printf("%zu objects, %zu triangles before, %zu lamps\n", shapes.objects.size(),
              shapes.indices.size() / 3, illumination.lamps.size());
  Illumination relative = illumination;
  for (Light& lamp : relative.lamps) lamp.position -= surface.origin();
  const LightBaker teller(surface.occluders(), relative, kTruth);
  const auto tell = [&](const BakeSettings& settings) {
    FixedMesh cut;
    const Bake baked = timeBakes(shapes, illumination, settings, runs, cut);
    printErrorBetween(cut, baked, teller);
  };
  for (const int rays : {8, 16, 32, 64, 128}) {
    FixedMesh cut;
    const Bake baked = timeBakes(shapes, illumination, {.rays = rays}, runs, cut);
    printError(mesh, lightOf(surface, illumination, rays), truth);
    printErrorBetween(cut, baked, teller);
  }
  for (const double tolerance : {0.04, 0.02, 0.015, 0.01, 0.007, 0.005}) tell({.tolerance = tolerance});
  for (const double finest : {0.16, 0.08, 0.06, 0.04, 0.02}) tell({.finest = finest});
  return 0;
}
