#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/egl.h>

#include "render_client/present/Display.h"

namespace coherency {
namespace {

bool hasExtension(const char* extensions, std::string_view name) {
  return extensions != nullptr &&
         (" " + std::string(extensions) + " ").find(" " + std::string(name) + " ") != std::string::npos;
}

bool softwareWanted() {
  const char* wanted = std::getenv("LIBGL_ALWAYS_SOFTWARE");
  return wanted != nullptr && std::string_view(wanted) != "0" && std::string_view(wanted) != "false";
}

/// A place EGL may find a driver at.
struct Candidate {
  EGLenum platform;
  void* native;
  std::string name;
};

std::vector<Candidate> candidates() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Candidate> gpus;
  std::vector<Candidate> others;
  if (hasExtension(client, "EGL_MESA_platform_surfaceless"))
    others.push_back({EGL_PLATFORM_SURFACELESS_MESA, nullptr, "Mesa surfaceless"});
  if (hasExtension(client, "EGL_EXT_platform_device") && hasExtension(client, "EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (EGLint i = 0; i < count; ++i) {
      EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
      const bool software =
          hasExtension(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
      auto& list = software || softwareWanted() ? others : gpus;
      list.push_back({EGL_PLATFORM_DEVICE_EXT, device, "EGL device " + std::to_string(i)});
    }
  }
  gpus.insert(gpus.end(), others.begin(), others.end());
  return gpus;
}

std::string eglErrorText() {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "EGL error 0x%04x", static_cast<unsigned>(eglGetError()));
  return text.data();
}

EGLContext makeContext(EGLDisplay display, int major, int minor) {
  const std::array<EGLint, 7> wanted{EGL_CONTEXT_MAJOR_VERSION,
                                     major,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     minor,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
}

/// For the error message: the newest version below 4.5 that the driver does give.
std::string newestVersion(EGLDisplay display) {
  for (const auto& [major, minor] :
       {std::pair{4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}, {3, 2}, {3, 1}}) {
    const EGLContext context = makeContext(display, major, minor);
    if (context == EGL_NO_CONTEXT) continue;
    eglDestroyContext(display, context);
    return "OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " at most";
  }
  return "no OpenGL core profile";
}

class HeadlessDisplay : public Display {
 public:
  explicit HeadlessDisplay(const DisplayConfig& config) : width_(config.width), height_(config.height) {
    if (width_ < 1 || height_ < 1)
      throw std::runtime_error("a picture of " + std::to_string(width_) + "x" + std::to_string(height_) +
                               " pixels cannot be drawn; both must be 1 or more");
    if (!epoxy_has_egl())  // asking anything else of EGL would end the process
      throw std::runtime_error(
          "no EGL to draw with headless (libEGL.so.1 cannot be loaded); install libegl1 and Mesa "
          "(libgl1-mesa-dri) or a graphics driver with EGL");
    std::string found;
    for (const Candidate& candidate : candidates()) {
      const std::string fault = open(candidate);
      if (fault.empty()) return;
      found += (found.empty() ? "" : "; ") + candidate.name + ": " + fault;
    }
    throw std::runtime_error("no OpenGL 4.5 to draw with headless (" +
                             (found.empty() ? "EGL has no platform" : found) +
                             "); install Mesa (libegl1 libgl1-mesa-dri) or a graphics driver with EGL");
  }

  ~HeadlessDisplay() override { close(); }

  DisplayInput poll() override { return {}; }

  void present() override {
    const EGLSync drawn = eglCreateSync(display_, EGL_SYNC_FENCE, nullptr);
    if (drawn == EGL_NO_SYNC) throw std::runtime_error("waiting for the GPU failed: " + eglErrorText());
    eglClientWaitSync(display_, drawn, EGL_SYNC_FLUSH_COMMANDS_BIT, EGL_FOREVER);
    eglDestroySync(display_, drawn);
  }

  bool hasWindow() const override { return false; }
  double refreshHz() const override { return 0.0; }
  int width() const override { return width_; }
  int height() const override { return height_; }

 private:
  /// Returns what is wrong, or nothing when the context is current.
  std::string open(const Candidate& candidate) {
    display_ = eglGetPlatformDisplayEXT(candidate.platform, candidate.native, nullptr);
    EGLint major = 0;
    EGLint minor = 0;
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, &major, &minor) != EGL_TRUE)
      return "no display (" + eglErrorText() + ")";
    std::string fault = makeCurrent(major, minor);
    if (!fault.empty()) close();
    return fault;
  }

  std::string makeCurrent(int major, int minor) {
    if (std::pair{major, minor} < std::pair{1, 5})
      return "EGL " + std::to_string(major) + "." + std::to_string(minor) + ", 1.5 is needed";
    const char* extensions = eglQueryString(display_, EGL_EXTENSIONS);
    for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"})
      if (!hasExtension(extensions, needed)) return std::string("lacks ") + needed;
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return "no desktop OpenGL";
    context_ = makeContext(display_, 4, 5);
    if (context_ == EGL_NO_CONTEXT) return newestVersion(display_);
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) return eglErrorText();
    return {};
  }

  void close() {
    if (display_ == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
    context_ = EGL_NO_CONTEXT;
    display_ = EGL_NO_DISPLAY;
  }

  int width_;
  int height_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Display> makeHeadlessDisplay(const DisplayConfig& config) {
  return std::make_unique<HeadlessDisplay>(config);
}

}  // namespace coherency
