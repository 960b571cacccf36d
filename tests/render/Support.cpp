#include "tests/render/Support.h"

#include <cmath>
#include <cstdlib>

#include <epoxy/egl.h>

namespace coherency {

bool anyEglDisplay() {
  if (!epoxy_has_egl()) return false;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const std::string known = extensions == nullptr ? "" : extensions;
  EGLint devices = 0;
  if (known.find("EGL_EXT_device_enumeration") != std::string::npos &&
      eglQueryDevicesEXT(0, nullptr, &devices) == EGL_TRUE && devices > 0)
    return true;
  if (known.find("EGL_MESA_platform_surfaceless") == std::string::npos) return false;
  const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

Display& DrawingTest::display() {
  // Never closed: the driver would be unloaded at exit, and what its own globals hold would count as leaked.
  static Display* const made = makeHeadlessDisplay({}).release();
  return *made;
}

void DrawingTest::SetUp() {
  if (!anyEglDisplay()) GTEST_SKIP() << "this machine has no EGL display to draw with";
  display();
}

namespace {

SceneDescription eyesOnly() {
  SceneDescription description;
  description.name = "test";
  description.operator_shown = false;
  description.driving = false;
  return description;
}

}  // namespace

SeenScene::SeenScene(const Rig& rig) : Filled<Scene>(eyesOnly(), rig) {}

EyeView lookingAhead(const Coord3& at, int width, int height, double tangent) {
  const double up = tangent * height / width;
  const TransformMatrix t_world_vehicle = TransformMatrix::translation(at - Coord3{0.0, 1.0, 0.0});
  return {TransformMatrix::translation(at),
          {tangent, tangent, up, up},
          0.01,
          0,
          0,
          width,
          height,
          t_world_vehicle};
}

Image picture(Renderer& renderer, std::span<const EyeView> views) {
  renderer.draw(views);
  return renderer.readImage();
}

int value(const Image& image, int x, int y, Channel channel) {
  const auto pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  return image.rgb.at(pixel * 3 + channel);
}

double linear(int byte) {
  const double encoded = byte / 255.0;
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Spot spot(const Image& image, Channel channel, int x_begin, int x_end) {
  Spot sum;
  for (int y = 0; y < image.height; ++y)
    for (int x = x_begin; x < x_end; ++x) {
      const double light = linear(value(image, x, y, channel));
      sum.light += light;
      sum.x += light * (x + 0.5);
      sum.y += light * (y + 0.5);
    }
  sum.x /= sum.light;
  sum.y /= sum.light;
  return sum;
}

double shareDiffering(const Image& a, const Image& b, int tolerance) {
  if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size()) return 1.0;
  int differing = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t c = i; c < i + 3; ++c) most = std::max(most, std::abs(a.rgb[c] - b.rgb[c]));
    differing += most > tolerance ? 1 : 0;
  }
  return 3.0 * differing / static_cast<double>(a.rgb.size());
}

bool sameDrawn(Renderer& a, Renderer& b, std::span<const EyeView> views) {
  if (shareDiffering(picture(a, views), picture(b, views), 0) > 0.0) return false;
  const IdImage in_a = a.drawIds(views);
  const IdImage in_b = b.drawIds(views);
  return in_a.ids == in_b.ids && in_a.objects == in_b.objects;
}

Image columns(const Image& image, int x_begin, int x_end) {
  Image cut{x_end - x_begin, image.height, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = x_begin; x < x_end; ++x)
      for (const Channel channel : {Red, Green, Blue})
        cut.rgb.push_back(static_cast<std::uint8_t>(value(image, x, y, channel)));
  return cut;
}

}  // namespace coherency
