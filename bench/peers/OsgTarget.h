#pragma once

#include <memory>

#include "render_client/draw/Image.h"

namespace coherency {

/// What OpenSceneGraph draws to: a target like the others', in a context of OpenGL 4.5 with all that older
/// ones had, which Debian's OpenSceneGraph is built for, current in the calling thread. Apart from osg.cpp,
/// as OpenSceneGraph's headers and epoxy's do not go together.
class OsgTarget {
 public:
  /// Throws std::runtime_error where Mesa's surfaceless platform is not there, or what RenderTarget throws.
  OsgTarget(int width, int height, int samples);
  ~OsgTarget();
  OsgTarget(const OsgTarget&) = delete;
  OsgTarget& operator=(const OsgTarget&) = delete;

  void bind() const;
  void finish() const;  ///< returns when all is drawn
  Image read() const;

 private:
  struct Gl;
  std::unique_ptr<Gl> gl_;
};

}  // namespace coherency
