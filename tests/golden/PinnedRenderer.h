#pragma once

#include <string>

namespace coherency::golden {

/// Who draws, as GL_RENDERER and GL_VERSION have it. llvmpipe's name ends with the width of its vectors, and
/// pixels depend on that; LP_NATIVE_VECTOR_WIDTH=128 makes it the same on every x86 processor.
struct GlName {
  std::string renderer;
  std::string version;
  bool operator==(const GlName&) const = default;
  std::string text() const { return "'" + renderer + "', '" + version + "'"; }
};

/// Of the current context.
GlName currentRenderer();
/// That the golden pictures were made with (tests/golden/renderer.txt). Throws std::runtime_error where the
/// file is not two lines.
GlName pinnedRenderer();

/// Whether its pictures may be held against those of the pinned one: llvmpipe of the same width, of whatever
/// version.
bool comparable(const GlName& renderer, const GlName& pinned);

}  // namespace coherency::golden
