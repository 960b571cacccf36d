#pragma once

#include <memory>
#include <string>

namespace coherency {

struct DisplayConfig {
  int width = 640;
  int height = 480;
  bool fullscreen = false;
  int monitor = 0;  ///< counted from 0, the primary one; a wrong number is answered with those there are
  bool vsync = true;
  std::string title = "Coherency";
};

/// What the operator asked for at the keyboard since the last poll.
struct DisplayInput {
  bool close = false;           ///< Esc, or the window was closed
  bool snapshot = false;        ///< F2
  bool toggle_overlay = false;  ///< F1
  bool switch_mode = false;     ///< F3
};

/// Where pictures go: a window, or nowhere (headless). Construction makes an OpenGL 4.5 core context current
/// in the calling thread, where it stays. The same drawing code runs on either. One display at a time in a
/// process.
class Display {
 public:
  Display() = default;
  virtual ~Display() = default;
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  virtual DisplayInput poll() = 0;
  /// Shows what was drawn to framebuffer 0; returns when the picture has been handed over (a window waits for
  /// its vertical sync; headless waits for the drawing to be complete).
  virtual void present() = 0;
  virtual bool hasWindow() const = 0;
  /// Framebuffer's size in pixels, which a window may change; its width is never below 2, so that two eyes
  /// fit.
  virtual int width() const = 0;
  virtual int height() const = 0;
  /// Pictures a second the monitor shows; 0 where there is none or it does not say.
  virtual double refreshHz() const = 0;
};

/// EGL without a surface: a GPU's EGL device where there is one, else Mesa's surfaceless platform (and with
/// LIBGL_ALWAYS_SOFTWARE=1 that first). Throws std::runtime_error naming what is missing and the remedy.
std::unique_ptr<Display> makeHeadlessDisplay(const DisplayConfig& config);
/// GLFW window. Throws std::runtime_error when there is no display, no OpenGL 4.5, or no such monitor (naming
/// those there are).
std::unique_ptr<Display> makeWindowDisplay(const DisplayConfig& config);

}  // namespace coherency
