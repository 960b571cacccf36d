#pragma once

#include <span>
#include <string>
#include <vector>

#include "render_client/draw/EyeView.h"
#include "render_client/draw/GlObjects.h"

namespace coherency {

/// Lines of text on a dark translucent ground, in the bitmap letters of stb_easy_font. Printable ASCII;
/// anything else shows as '?'. What is beyond some thousand letters is left out. Allocates nothing once made.
class TextOverlay {
 public:
  TextOverlay();
  /// Where each view has its text (EyeView), in the bound framebuffer, lines broken to the narrowest; smaller
  /// where that is narrow. Leaves blending off.
  void draw(std::span<const EyeView> views, const std::string& text);

 private:
  void breakLines(const std::string& text, float widest);
  std::size_t layOut(const std::string& text, float widest);

  Program program_;
  Buffer corners_buffer_;
  Buffer indices_;
  VertexArray vertex_array_;
  std::string letters_;
  std::vector<unsigned char> corners_;
};

}  // namespace coherency
