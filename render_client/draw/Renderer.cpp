#include "render_client/draw/Renderer.h"

#include <cassert>
#include <optional>
#include <stdexcept>

#include <epoxy/gl.h>

#include "render_client/compile/ToneCurve.h"
#include "render_client/draw/DistortionPass.h"
#include "render_client/draw/DrawnScene.h"
#include "render_client/draw/RenderTarget.h"
#include "render_client/draw/TextOverlay.h"

namespace coherency {
namespace {

std::string glText(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

/// First of all members, so that nothing is asked of a context that cannot do it.
struct VersionCheck {
  VersionCheck() {
    if (epoxy_is_desktop_gl() && epoxy_gl_version() >= 45) return;
    throw std::runtime_error("OpenGL 4.5 is needed, but the driver has '" + glText(GL_VERSION) + "' (" +
                             glText(GL_RENDERER) +
                             "); update it, or use Mesa's llvmpipe (LIBGL_ALWAYS_SOFTWARE=1)");
  }
};

void setDrawingState() {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glClearDepth(0.0);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_MULTISAMPLE);
  glDisable(GL_FRAMEBUFFER_SRGB);  // the shaders encode
}

RendererSettings neededBy(const Scene& scene, RendererSettings settings) {
  settings.two_vehicles = settings.two_vehicles && scene.robot() != nullptr;
  return settings;
}

}  // namespace

struct Renderer::Gl {
  Gl(const VRObject& root, Illumination illumination_, int width, int height,
     const RendererSettings& settings_)
      : settings(settings_),
        illumination(std::move(illumination_)),
        scene(std::make_unique<DrawnScene>(root, illumination, settings)),
        target(width, height, settings.samples) {}

  /// Compiles the tree again where it is not as it was compiled. Where that throws, the next call tries
  /// again.
  void followTree() {
    if (!scene->compiled().isStale()) return;
    const VRObject* const root = scene->compiled().root();
    if (root == nullptr)
      throw std::logic_error(
          "Renderer::draw: the tree it was made for has died; make a new one, or end this first");
    scene = std::make_unique<DrawnScene>(*root, illumination, settings, scene->compiled().foundToMove());
    ++compilations;
  }

  void resolve() {
    if (resolved) return;
    target.resolve();
    resolved = true;
  }

  void distort(int width, int height) {
    resolve();
    distortion->draw(target.texture(), target.width(), target.height(), width, height);
  }

  VersionCheck version;
  RendererSettings settings;
  Illumination illumination;
  std::unique_ptr<DrawnScene> scene;  ///< never null
  std::size_t compilations = 1;
  TextOverlay text;
  RenderTarget target;
  std::optional<DistortionPass> distortion;
  bool resolved = false;
};

Renderer::Renderer(const VRObject& root, const Illumination& illumination, int width, int height,
                   const RendererSettings& settings)
    : gl_(std::make_unique<Gl>(root, illumination, width, height, settings)) {}

Renderer::Renderer(const Scene& scene, int width, int height, const RendererSettings& settings)
    : Renderer(scene, {scene.lights(), scene.ambient()}, width, height, neededBy(scene, settings)) {}

Renderer::~Renderer() = default;

void Renderer::prepare(std::span<const EyeView> views) {
  gl_->followTree();
  gl_->scene->prepare(views);
}

void Renderer::draw(std::span<const EyeView> views) {
  setDrawingState();
  gl_->followTree();
  gl_->scene->prepare(views);
  if (!views.empty()) gl_->scene->drawShadows();
  gl_->target.bind();
  const glm::vec3 sky(gl_->illumination.ambient.sky.glm());
  glClearColor(encoded(tone(sky.r)), encoded(tone(sky.g)), encoded(tone(sky.b)), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_->scene->draw(views);
  gl_->resolved = false;
  assert(glGetError() == GL_NO_ERROR);
}

void Renderer::drawText(std::span<const EyeView> views, const std::string& text) {
  gl_->target.bind();
  gl_->text.draw(views, text);
  gl_->resolved = false;
  assert(glGetError() == GL_NO_ERROR);
}

void Renderer::setDisplay(const HmdProfile& hmd, EyeChoice eyes, double render_scale) {
  gl_->distortion.reset();
  if (hasLens(hmd, eyes)) gl_->distortion.emplace(hmd, eyes, render_scale);
}

void Renderer::finish() {
  glFinish();
}

void Renderer::present(int width, int height) {
  if (gl_->distortion) {
    gl_->distort(width, height);
    copyToWindow(gl_->distortion->framebuffer(), width, height, width, height);
  } else {
    gl_->resolve();
    gl_->target.copyToWindow(width, height);
  }
  assert(glGetError() == GL_NO_ERROR);
}

Image Renderer::readImage() {
  gl_->resolve();
  return gl_->target.read();
}

Image Renderer::readPanel(int width, int height) {
  if (!gl_->distortion) return readImage();
  gl_->distort(width, height);
  return readPixels(gl_->distortion->framebuffer(), width, height);
}

IdImage Renderer::drawIds(std::span<const EyeView> views) {
  setDrawingState();
  gl_->followTree();
  gl_->scene->prepare(views);
  IdImage image = gl_->scene->drawIds(views, gl_->target.width(), gl_->target.height());
  assert(glGetError() == GL_NO_ERROR);
  return image;
}

void Renderer::resize(int width, int height) {
  if (width == gl_->target.width() && height == gl_->target.height()) return;
  gl_->target = RenderTarget(width, height, gl_->settings.samples);  // the old one stays where this throws
  gl_->resolved = false;
}

int Renderer::samples() const {
  return gl_->target.samples();
}
std::string Renderer::rendererName() const {
  return glText(GL_RENDERER);
}
std::size_t Renderer::triangleCount() const {
  const CompileReport& of = report();
  return of.lit.triangles + of.mapped.triangles + of.moving.triangles;
}
std::size_t Renderer::vertexCount() const {
  const CompileReport& of = report();
  return of.lit.vertices + of.mapped.vertices + of.moving.vertices;
}
FrameCounts Renderer::counts() const {
  return gl_->scene->counts();
}
const CompileReport& Renderer::report() const {
  return gl_->scene->compiled().report();
}
std::string Renderer::explain() const {
  return gl_->scene->explain();
}
std::size_t Renderer::compilations() const {
  return gl_->compilations;
}

}  // namespace coherency
