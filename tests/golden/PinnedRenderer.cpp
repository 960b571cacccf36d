#include "tests/golden/PinnedRenderer.h"

#include <fstream>
#include <stdexcept>

#include <epoxy/gl.h>

namespace coherency::golden {
namespace {

constexpr const char* kFile = COHERENCY_GOLDEN "/renderer.txt";

std::string text(GLenum name) {
  return reinterpret_cast<const char*>(glGetString(name));
}

/// "128 bits" of "llvmpipe (LLVM 15.0.6, 128 bits)".
std::string width(const std::string& renderer) {
  const std::size_t comma = renderer.find(", ");
  return comma == std::string::npos ? "" : renderer.substr(comma);
}

}  // namespace

GlName currentRenderer() {
  return {text(GL_RENDERER), text(GL_VERSION)};
}

GlName pinnedRenderer() {
  std::ifstream in(kFile);
  GlName pinned;
  if (!std::getline(in, pinned.renderer) || !std::getline(in, pinned.version))
    throw std::runtime_error(std::string(kFile) + ": must be two lines, GL_RENDERER and GL_VERSION");
  return pinned;
}

bool comparable(const GlName& renderer, const GlName& pinned) {
  return renderer.renderer.starts_with("llvmpipe") && width(renderer.renderer) == width(pinned.renderer);
}

}  // namespace coherency::golden
