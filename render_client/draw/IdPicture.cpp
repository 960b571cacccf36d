#include "render_client/draw/IdPicture.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "render_client/draw/ShaderProgram.h"

namespace coherency {
namespace {

Program programFor(LightSource light) {
  const ShaderVariant variant{.light = light, .ids = true};
  return makeProgram("ids",
                     light == LightSource::Lamps ? movingVertexShader(variant) : fixedVertexShader(variant),
                     fragmentShader(variant));
}

/// A pixel as the shader writes it: LightSource + 1, or 0 for nothing; which draw command of its pass, and
/// which of its triangles.
struct Drawn {
  std::uint32_t light, number, triangle, unused;
};

/// Whose the triangle is. Parts lie in the buffer as they do in the list.
template <class Vertex>
const VRObject* objectOf(const BlockSurfaces<Vertex>& surfaces, const BlockPass& pass, const Drawn& drawn) {
  const std::uint32_t index = pass.drawn(drawn.number).first_index + 3 * drawn.triangle;
  const auto after =
      std::upper_bound(surfaces.parts.begin(), surfaces.parts.end(), index,
                       [](std::uint32_t i, const BlockPart& part) { return i < part.range.first_index; });
  return std::prev(after)->object;
}

}  // namespace

IdPicture::IdPicture(const CompiledScene& scene)
    : scene_(scene),
      programs_{programFor(LightSource::Vertices), programFor(LightSource::Lightmap),
                programFor(LightSource::Lamps)} {
  const auto add = [&](const VRObject* object) {
    if (ids_.emplace(object, objects_.size() + 1).second) objects_.push_back(object);
  };
  for (const BlockPart& part : scene.fixed().lit.parts) add(part.object);
  for (const BlockPart& part : scene.fixed().mapped.parts) add(part.object);
  for (const Drawable& drawable : scene.moving().drawables) add(&scene.object(drawable));
}

void IdPicture::begin(int width, int height) {
  if (width != width_ || height != height_) {
    Target made;
    glNamedRenderbufferStorage(made.colour.name(), GL_RGBA32UI, width, height);
    glNamedRenderbufferStorage(made.depth.name(), GL_DEPTH_COMPONENT32F, width, height);
    glNamedFramebufferRenderbuffer(made.frame.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                   made.colour.name());
    glNamedFramebufferRenderbuffer(made.frame.name(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                   made.depth.name());
    if (glCheckNamedFramebufferStatus(made.frame.name(), GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw std::runtime_error("the driver cannot draw the numbers of objects to " + std::to_string(width) +
                               "x" + std::to_string(height) + " pixels");
    target_ = std::move(made);
    width_ = width;
    height_ = height;
  }
  constexpr Drawn kNothing{};
  constexpr float kFarthest = 0.0F;
  glBindFramebuffer(GL_FRAMEBUFFER, target_.frame.name());
  glClearBufferuiv(GL_COLOR, 0, &kNothing.light);
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
}

IdImage IdPicture::read(const MovingPass* moving, const BlockPass* lit, const BlockPass* mapped) const {
  const auto object = [&](const Drawn& drawn) {
    switch (static_cast<LightSource>(drawn.light - 1)) {
      case LightSource::Vertices:
        return objectOf(scene_.fixed().lit, *lit, drawn);
      case LightSource::Lightmap:
        return objectOf(scene_.fixed().mapped, *mapped, drawn);
      case LightSource::Lamps:
        break;
    }
    return &scene_.object(scene_.moving().drawables[moving->drawn(drawn.number)]);
  };
  const auto columns = static_cast<std::size_t>(width_);
  const auto rows = static_cast<std::size_t>(height_);
  std::vector<Drawn> drawn(columns * rows);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.frame.name());
  glReadPixels(0, 0, width_, height_, GL_RGBA_INTEGER, GL_UNSIGNED_INT, drawn.data());
  IdImage image{width_, height_, {}, objects_};
  image.ids.reserve(drawn.size());
  for (std::size_t row = rows; row-- > 0;)
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i)
      image.ids.push_back(drawn[i].light == 0 ? 0U : ids_.at(object(drawn[i])));
  return image;
}

}  // namespace coherency
