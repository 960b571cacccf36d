#pragma once

#include <optional>
#include <span>

#include "common/scene/Light.h"
#include "render_client/draw/EyeView.h"
#include "render_client/draw/OverheadShadow.h"
#include "render_client/draw/StreamBuffer.h"

namespace coherency {

/// What all shaders of a view read: the projection, the light from everywhere, and where shadows are.
class ViewUniforms {
 public:
  /// `origin`: of the coordinates in which is drawn, in the world. `shadow` may be null. Allocates where
  /// there are more views than ever before.
  void write(std::span<const EyeView> views, const Coord3& origin, const Ambient& ambient,
             const OverheadShadow* shadow);
  /// A view's, to uniform binding 0.
  void bind(std::size_t view) const;

 private:
  std::size_t room_ = 0;    ///< views
  std::size_t stride_ = 0;  ///< bytes a view
  std::optional<StreamBuffer> buffer_;
};

}  // namespace coherency
