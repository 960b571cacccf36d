#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/BlockPass.h"
#include "render_client/draw/IdImage.h"
#include "render_client/draw/MovingPass.h"

namespace coherency {

/// The picture with the objects' numbers in place of their colours (Hanrahan & Haeberli, "Direct WYSIWYG
/// painting and texturing on 3D shapes", 1990), one sample a pixel: what the passes draw in a frame, drawn by
/// the same commands with the same vertex shaders, so that it has all that the picture has, and in the same
/// places. For tests; it is read back at once.
class IdPicture {
 public:
  /// `scene` must outlive this.
  explicit IdPicture(const CompiledScene& scene);

  /// Binds and clears a target of that size. Throws std::runtime_error where the driver has none.
  void begin(int width, int height);
  /// Draws what has its light from there.
  const Program& program(LightSource light) const { return programs_[static_cast<std::size_t>(light)]; }
  /// `moving`, `lit` and `mapped` as they were drawn; null: there is none.
  IdImage read(const MovingPass* moving, const BlockPass* lit, const BlockPass* mapped) const;

 private:
  struct Target {
    Framebuffer frame;
    Renderbuffer colour;
    Renderbuffer depth;
  };

  const CompiledScene& scene_;
  std::array<Program, 3> programs_;
  Target target_;
  int width_ = 0;
  int height_ = 0;
  std::vector<const VRObject*> objects_;
  std::unordered_map<const VRObject*, std::uint32_t> ids_;
};

}  // namespace coherency
