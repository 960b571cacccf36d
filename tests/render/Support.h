#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/scene/Primitives.h"
#include "common/world/Scene.h"
#include "render_client/draw/Renderer.h"
#include "render_client/present/Display.h"

namespace coherency {

/// Whether this machine has any EGL display at all; without one there is nothing to test drawing with.
bool anyEglDisplay();

/// A test that draws: makes the headless context current, once a process. Fails, rather than being skipped,
/// where there is an EGL display but no OpenGL 4.5.
class DrawingTest : public testing::Test {
 protected:
  void SetUp() override;
  static Display& display();
};

/// Something to draw: black, without light; objects are added one by one and live as long as it does.
template <class Root>
class Filled : public Root {
 public:
  using Root::Root;

  void setAmbient(const Coord3& sky, const Coord3& ground) { illumination_.ambient = {sky, ground}; }
  void addLight(const Light& lamp) { illumination_.lamps.push_back(lamp); }
  const Illumination& illumination() const { return illumination_; }

  template <class Kind, class... Arguments>
  Kind& add(const Coord3& at, const Material& material, Arguments&&... arguments) {
    auto made = std::make_unique<Kind>(std::forward<Arguments>(arguments)...);
    Kind& object = *made;
    object.setMaterial(material);
    object.setPosition(at);
    this->addMember(&object);
    objects_.push_back(std::move(made));
    return object;
  }
  template <class Kind, class... Arguments>
  Kind& addMoving(const Coord3& at, const Material& material, Arguments&&... arguments) {
    Kind& object = add<Kind>(at, material, std::forward<Arguments>(arguments)...);
    object.attach(Moving{});
    return object;
  }

 private:
  Illumination illumination_{{}, {{}, {}}};
  std::vector<std::unique_ptr<VRObject>> objects_;
};

using TestScene = Filled<VRObject>;

/// With somebody to look at it: a pair of eyes and nothing else.
class SeenScene : public Filled<Scene> {
 public:
  explicit SeenScene(const Rig& rig = {});
};

/// Shines by itself, evenly, whatever the light.
inline Material glow(double r, double g, double b) {
  return {{r, g, b}, 0.0, 1.0};
}
inline Material matt(double r, double g, double b) {
  return {{r, g, b}, 0.0, 0.0};
}
inline const Material kRed = glow(1.0, 0.0, 0.0);
inline const Material kGreen = glow(0.0, 1.0, 0.0);
inline const Material kBlue = glow(0.0, 0.0, 1.0);

/// An eye at `at`, upright, with a symmetric view of `tangent` to the left and right, on the whole of a
/// picture; its vehicle stands 1 m below it.
EyeView lookingAhead(const Coord3& at, int width, int height, double tangent = 1.0);

Image picture(Renderer& renderer, std::span<const EyeView> views);
template <class Root>
Image picture(const Filled<Root>& scene, const EyeView& view, const RendererSettings& settings = {}) {
  Renderer renderer(scene, scene.illumination(), view.width, view.height, settings);
  return picture(renderer, {&view, 1});
}

enum Channel { Red = 0, Green = 1, Blue = 2 };
int value(const Image& image, int x, int y, Channel channel);
/// Light of an sRGB byte, 0..1.
double linear(int byte);

/// What shows in one channel of the columns from x_begin to x_end, in pixel coordinates as projectToPixels()
/// has them.
struct Spot {
  double x = 0.0;  ///< centroid, weighted by light
  double y = 0.0;
  double light = 0.0;  ///< sum over the pixels
};
Spot spot(const Image& image, Channel channel, int x_begin, int x_end);
inline Spot spot(const Image& image, Channel channel) {
  return spot(image, channel, 0, image.width);
}

/// Share of the pixels of which some channel differs by more than `tolerance`; 1 where the sizes differ.
double shareDiffering(const Image& a, const Image& b, int tolerance);
/// Whether both renderers, of one scene, draw the same colours and the same objects in every pixel.
bool sameDrawn(Renderer& a, Renderer& b, std::span<const EyeView> views);
/// Columns x_begin to x_end.
Image columns(const Image& image, int x_begin, int x_end);

}  // namespace coherency
