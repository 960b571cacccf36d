#pragma once

#include "common/scene/Light.h"
#include "render_client/draw/EyeView.h"
#include "render_client/draw/OverheadShadow.h"
#include "render_client/draw/SlottedBuffer.h"

namespace coherency {

/// What all shaders of a view read: the projection, the light from everywhere, and where shadows are.
class ViewUniforms {
 public:
  ViewUniforms();

  void reserve(std::size_t views) { buffer_.reserve(views); }
  /// `shadow` may be null.
  void write(std::size_t slot, const EyeView& view, const Ambient& ambient, const OverheadShadow* shadow);
  /// To uniform binding 0.
  void bind(std::size_t slot) const { buffer_.bind(slot, 0); }

 private:
  SlottedBuffer buffer_;
};

}  // namespace coherency
