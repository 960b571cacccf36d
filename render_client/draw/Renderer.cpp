#include "render_client/draw/Renderer.h"

#include <cassert>
#include <optional>
#include <stdexcept>

#include <epoxy/gl.h>

#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/RenderTarget.h"
#include "render_client/draw/SceneBuffers.h"
#include "render_client/draw/ShadowMap.h"
#include "render_client/draw/TextOverlay.h"
#include "render_client/draw/ViewPass.h"

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

/// As the far end of the shader's tone curve sees it.
float tone(double c) {
  const double over = std::max(c - 0.6, 0.0) / 0.4;
  return static_cast<float>(std::min(c, 0.6) + 0.4 * over / (1.0 + over));
}

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
  glEnable(GL_FRAMEBUFFER_SRGB);
}

}  // namespace

struct Renderer::Gl {
  Gl(const Scene& scene_, int width, int height, const RendererSettings& settings_)
      : scene(scene_),
        settings(settings_),
        compiled(scene_),
        buffers(compiled),
        pass(compiled.drawables().size(), scene_.lights().size(),
             settings_.shadows && !scene_.lights().empty()),
        target(width, height, settings_.samples) {
    if (settings.shadows && !scene.lights().empty())
      shadow.emplace(settings.shadow_resolution, compiled.drawables().size());
  }

  void resolve() {
    if (resolved) return;
    target.resolve();
    resolved = true;
  }

  VersionCheck version;
  const Scene& scene;
  RendererSettings settings;
  CompiledScene compiled;
  SceneBuffers buffers;
  ViewPass pass;
  TextOverlay text;
  RenderTarget target;
  std::optional<ShadowMap> shadow;
  bool resolved = false;
};

Renderer::Renderer(const Scene& scene, int width, int height, const RendererSettings& settings)
    : gl_(std::make_unique<Gl>(scene, width, height, settings)) {}

Renderer::~Renderer() = default;

void Renderer::draw(std::span<const EyeView> views) {
  setDrawingState();
  gl_->compiled.update();
  const ShadowMap* shadow = nullptr;
  if (gl_->shadow) {
    gl_->shadow->render(gl_->compiled, gl_->buffers, gl_->scene.lights().front());
    shadow = &*gl_->shadow;
  }
  gl_->target.bind();
  const Coord3 sky = gl_->scene.skyLight();
  glClearColor(tone(sky.x), tone(sky.y), tone(sky.z), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (views.empty()) return;
  gl_->pass.begin(gl_->compiled, views.front().t_world_eye.origin(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i)
    gl_->pass.draw(i, views[i], gl_->scene, gl_->compiled, gl_->buffers, shadow);
  gl_->resolved = false;
  assert(glGetError() == GL_NO_ERROR);
}

void Renderer::drawText(std::span<const EyeView> views, const std::string& text) {
  gl_->target.bind();
  gl_->text.draw(views, text);
  gl_->resolved = false;
  assert(glGetError() == GL_NO_ERROR);
}

void Renderer::present(int width, int height) {
  gl_->resolve();
  gl_->target.copyToWindow(width, height);
}

Image Renderer::readImage() {
  gl_->resolve();
  return gl_->target.read();
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
  std::size_t triangles = 0;
  for (const Drawable& drawable : gl_->compiled.drawables()) triangles += drawable.index_count / 3;
  return triangles;
}
std::size_t Renderer::objectCount() const {
  return gl_->compiled.drawables().size();
}

}  // namespace coherency
