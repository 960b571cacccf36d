#include "render_client/draw/Renderer.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <stdexcept>

#include <epoxy/gl.h>

#include "render_client/compile/CompiledScene.h"
#include "render_client/compile/ToneCurve.h"
#include "render_client/draw/BlockPass.h"
#include "render_client/draw/DistortionPass.h"
#include "render_client/draw/IdPicture.h"
#include "render_client/draw/LampSets.h"
#include "render_client/draw/MovingPass.h"
#include "render_client/draw/OverheadShadow.h"
#include "render_client/draw/RenderTarget.h"
#include "render_client/draw/SceneBuffers.h"
#include "render_client/draw/TextOverlay.h"
#include "render_client/draw/ViewUniforms.h"

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

}  // namespace

struct Renderer::Gl {
  Gl(const VRObject& root, const Illumination& illumination, int width, int height,
     const RendererSettings& settings_)
      : settings(settings_),
        ambient(illumination.ambient),
        compiled(root, illumination, settings_.bake),
        buffers(compiled),
        lamps(illumination, compiled),
        moving(compiled, std::min(illumination.lamps.size(), kChosenLamps), shadowResolution()),
        lit(compiled.fixed().lit.blocks, LightSource::Vertices, shadowResolution()),
        mapped(compiled.fixed().mapped.blocks, LightSource::Lightmap, shadowResolution()),
        enclosures(compiled.enclosures()),
        target(width, height, settings_.samples) {
    if (settings.shadows) shadow.emplace(settings.shadow_resolution, compiled.moving().drawables.size());
  }

  int shadowResolution() const { return settings.shadows ? settings.shadow_resolution : 0; }

  void clipTo(std::span<const EyeView> views) {
    pyramids.clear();
    enclosures.begin();
    if (!settings.clip) return;
    for (const EyeView& view : views) {
      pyramids.add({view.t_world_eye, view.view, view.near_m});
      const double pixel = std::max((view.view.tan_left + view.view.tan_right) / view.width,
                                    (view.view.tan_down + view.view.tan_up) / view.height);
      enclosures.addView(view.t_world_eye, view.view, view.near_m, pixel);
    }
  }

  /// All that is done for a frame before the GPU is told to draw it.
  void prepare(std::span<const EyeView> views) {
    compiled.update();
    clipTo(views);
    if (views.empty()) return;
    const Coord3 origin = views.front().t_world_eye.origin();
    if (shadow) shadow->update(compiled, views.front(), pyramids);
    const OverheadShadow* const map = shadow ? &*shadow : nullptr;
    lamps.update();
    uniforms.write(views, origin, ambient, map);
    moving.begin(compiled, lamps, origin, pyramids, enclosures);
    lit.begin(origin, pyramids, enclosures, map);
    mapped.begin(origin, pyramids, enclosures, map);
  }

  /// The picture, or with `instead` what shows in it.
  void draw(std::span<const EyeView> views, const IdPicture* instead = nullptr) {
    const auto program = [&](LightSource light) {
      return instead == nullptr ? nullptr : &instead->program(light);
    };
    if (shadow) shadow->bindTexture();
    for (std::size_t i = 0; i < views.size(); ++i) {
      uniforms.bind(i);
      glViewport(views[i].x, views[i].y, views[i].width, views[i].height);
      moving.draw(buffers, program(LightSource::Lamps));
      buffers.bindMapped();
      mapped.draw(program(LightSource::Lightmap));
      buffers.bindLit();  // the sky is among it: behind everything
      lit.draw(program(LightSource::Vertices));
    }
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
  Ambient ambient;
  CompiledScene compiled;
  SceneBuffers buffers;
  LampSets lamps;
  MovingPass moving;
  BlockPass lit;
  BlockPass mapped;
  ViewPyramids pyramids;
  Enclosures enclosures;
  ViewUniforms uniforms;
  TextOverlay text;
  RenderTarget target;
  std::optional<OverheadShadow> shadow;
  std::optional<DistortionPass> distortion;
  std::optional<IdPicture> ids;  ///< once it has been asked for
  bool resolved = false;
};

Renderer::Renderer(const VRObject& root, const Illumination& illumination, int width, int height,
                   const RendererSettings& settings)
    : gl_(std::make_unique<Gl>(root, illumination, width, height, settings)) {}

Renderer::~Renderer() = default;

void Renderer::prepare(std::span<const EyeView> views) {
  gl_->prepare(views);
}

void Renderer::draw(std::span<const EyeView> views) {
  setDrawingState();
  gl_->prepare(views);
  if (gl_->shadow && !views.empty()) gl_->shadow->draw(gl_->compiled, gl_->buffers);
  gl_->target.bind();
  const glm::vec3 sky(gl_->ambient.sky.glm());
  glClearColor(encoded(tone(sky.r)), encoded(tone(sky.g)), encoded(tone(sky.b)), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_->draw(views);
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
  if (!gl_->ids) gl_->ids.emplace(gl_->compiled);
  setDrawingState();
  gl_->prepare(views);
  gl_->ids->begin(gl_->target.width(), gl_->target.height());
  gl_->draw(views, &*gl_->ids);
  assert(glGetError() == GL_NO_ERROR);
  return gl_->ids->read(gl_->moving, gl_->lit, gl_->mapped);
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
  const CompiledScene& compiled = gl_->compiled;
  return (compiled.fixed().lit.indices.size() + compiled.fixed().mapped.indices.size() +
          compiled.moving().indices.size()) /
         3;
}
std::size_t Renderer::vertexCount() const {
  const CompiledScene& compiled = gl_->compiled;
  return compiled.fixed().lit.vertices.size() + compiled.fixed().mapped.vertices.size() +
         compiled.moving().vertices.size();
}
std::size_t Renderer::vertexBytes() const {
  const CompiledScene& compiled = gl_->compiled;
  return compiled.fixed().lit.vertices.size() * sizeof(LitVertex) +
         compiled.fixed().mapped.vertices.size() * sizeof(MappedVertex) +
         compiled.fixed().lightmap.texels().size() * sizeof(PackedLight) +
         compiled.moving().vertices.size() * sizeof(MeshVertex) + 3 * triangleCount() * sizeof(std::uint32_t);
}
std::size_t Renderer::objectCount() const {
  return gl_->compiled.fixed().object_count + gl_->compiled.moving().drawables.size();
}
FrameCounts Renderer::counts() const {
  return {gl_->moving.count(), gl_->lit.shadedCount() + gl_->mapped.shadedCount(),
          gl_->lit.plainCount() + gl_->mapped.plainCount()};
}

}  // namespace coherency
