#include "bench/peers/OsgTarget.h"

#include <array>
#include <stdexcept>

#include <epoxy/egl.h>

#include "render_client/draw/RenderTarget.h"

namespace coherency {
namespace {

struct Context {
  Context() {
    constexpr std::array<EGLint, 7> kWanted{EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                            EGL_NONE};
    if (eglInitialize(display, nullptr, nullptr) == EGL_TRUE && eglBindAPI(EGL_OPENGL_API) == EGL_TRUE)
      context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kWanted.data());
    if (context == EGL_NO_CONTEXT ||
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE)
      throw std::runtime_error(
          "no OpenGL 4.5 in the compatibility profile; install Mesa (libegl1 libgl1-mesa-dri)");
  }
  ~Context() {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglTerminate(display);
  }
  EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  EGLContext context = EGL_NO_CONTEXT;
};

}  // namespace

struct OsgTarget::Gl {
  Context context;
  RenderTarget target;
};

OsgTarget::OsgTarget(int width, int height, int samples) : gl_(new Gl{{}, {width, height, samples}}) {}
OsgTarget::~OsgTarget() = default;

void OsgTarget::bind() const {
  gl_->target.bind();
}

void OsgTarget::finish() const {
  glFinish();
}

Image OsgTarget::read() const {
  gl_->target.resolve();
  glDisable(GL_FRAMEBUFFER_SRGB);  // the shaders encode
  return gl_->target.read();
}

}  // namespace coherency
