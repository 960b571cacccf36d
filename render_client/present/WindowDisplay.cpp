#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <stdexcept>
#include <string>

#include <GLFW/glfw3.h>

#include "render_client/present/Display.h"

namespace coherency {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& remedy) {
  const char* text = nullptr;
  glfwGetError(&text);
  throw std::runtime_error(what + (text == nullptr ? "" : " (" + std::string(text) + ")") + "; " + remedy);
}

/// GLFW from construction to destruction.
struct Library {
  Library() {
    if (glfwInit() != GLFW_TRUE)
      fail("no display to open a window on",
           "set DISPLAY or WAYLAND_DISPLAY, or draw headless (--display headless)");
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

std::string describe(GLFWmonitor* monitor) {
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  const char* name = glfwGetMonitorName(monitor);
  return std::string(name == nullptr ? "unnamed" : name) +
         (mode == nullptr ? "" : " " + std::to_string(mode->width) + "x" + std::to_string(mode->height));
}

GLFWmonitor* monitorAt(int index) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  if (index >= 0 && index < count) return monitors[index];
  std::string known;
  for (int i = 0; i < count; ++i)
    known += (i == 0 ? "" : ", ") + std::to_string(i) + " (" + describe(monitors[i]) + ")";
  throw std::runtime_error("there is no monitor " + std::to_string(index) + "; there " +
                           (count == 0 ? "are none" : (count == 1 ? "is " : "are ") + known));
}

/// For the error message: what a window without any wish gets.
std::string newestVersion() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* probe = glfwCreateWindow(16, 16, "", nullptr, nullptr);
  if (probe == nullptr) return "has no OpenGL at all";
  const int major = glfwGetWindowAttrib(probe, GLFW_CONTEXT_VERSION_MAJOR);
  const int minor = glfwGetWindowAttrib(probe, GLFW_CONTEXT_VERSION_MINOR);
  glfwDestroyWindow(probe);
  return "has OpenGL " + std::to_string(major) + "." + std::to_string(minor);
}

void setHints() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

class WindowDisplay : public Display {
 public:
  explicit WindowDisplay(const DisplayConfig& config) {
    GLFWmonitor* monitor = monitorAt(config.monitor);
    setHints();
    window_ = config.fullscreen ? makeFullscreen(config, monitor) : makeWindow(config, monitor);
    if (const GLFWvidmode* mode = glfwGetVideoMode(monitor); mode != nullptr) refresh_hz_ = mode->refreshRate;
    if (window_ == nullptr) {
      const char* text = nullptr;
      glfwGetError(&text);
      const std::string reason = text == nullptr ? "unknown reason" : text;
      throw std::runtime_error("no window with OpenGL 4.5 (" + reason + "): the display's driver " +
                               newestVersion() + "; update it, or draw headless (--display headless)");
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(config.vsync ? 1 : 0);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, onKey);
    glfwSetFramebufferSizeCallback(window_, onSize);
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    setSize(width, height);
  }

  ~WindowDisplay() override {
    if (window_ != nullptr) glfwDestroyWindow(window_);
  }

  DisplayInput poll() override {
    glfwPollEvents();
    DisplayInput input = input_;
    input_ = {};
    input.close = input.close || glfwWindowShouldClose(window_) == GLFW_TRUE;
    return input;
  }

  void present() override { glfwSwapBuffers(window_); }
  bool hasWindow() const override { return true; }
  double refreshHz() const override { return refresh_hz_; }
  int width() const override { return width_; }
  int height() const override { return height_; }

 private:
  static GLFWwindow* makeFullscreen(const DisplayConfig& config, GLFWmonitor* monitor) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    if (mode == nullptr)
      fail("monitor " + std::to_string(config.monitor) + " has no mode", "is it switched on?");
    glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);  // the other eye's window may have the focus
    return glfwCreateWindow(mode->width, mode->height, config.title.c_str(), monitor, nullptr);
  }

  static GLFWwindow* makeWindow(const DisplayConfig& config, GLFWmonitor* monitor) {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* window =
        glfwCreateWindow(config.width, config.height, config.title.c_str(), nullptr, nullptr);
    if (window == nullptr) return nullptr;
    int x = 0;
    int y = 0;
    glfwGetMonitorPos(monitor, &x, &y);
    if (config.monitor != 0) glfwSetWindowPos(window, x, y);
    glfwShowWindow(window);
    return window;
  }

  static WindowDisplay& self(GLFWwindow* window) {
    return *static_cast<WindowDisplay*>(glfwGetWindowUserPointer(window));
  }

  static void onKey(GLFWwindow* window, int key, int, int action, int) {
    if (action != GLFW_PRESS) return;
    DisplayInput& input = self(window).input_;
    input.close = input.close || key == GLFW_KEY_ESCAPE;
    input.toggle_overlay = input.toggle_overlay != (key == GLFW_KEY_F1);  // twice in a poll is not at all
    input.snapshot = input.snapshot || key == GLFW_KEY_F2;
    input.switch_mode = input.switch_mode || key == GLFW_KEY_F3;
  }

  static void onSize(GLFWwindow* window, int width, int height) { self(window).setSize(width, height); }

  /// A minimised window has no size; it is drawn with one pixel for each of two eyes.
  void setSize(int width, int height) {
    width_ = std::max(width, 2);
    height_ = std::max(height, 1);
  }

  Library library_;
  GLFWwindow* window_ = nullptr;
  double refresh_hz_ = 0.0;
  int width_ = 1;
  int height_ = 1;
  DisplayInput input_;
};

}  // namespace

std::unique_ptr<Display> makeWindowDisplay(const DisplayConfig& config) {
  return std::make_unique<WindowDisplay>(config);
}

}  // namespace coherency
