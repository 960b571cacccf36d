#include "render_client/draw/OverheadShadow.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <glm/common.hpp>

#include "render_client/compile/NormalMatrix.h"
#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {
namespace {

constexpr double kHalf = 0.5 * kShadowTileWidth;
constexpr double kBelow = 1.0;   // m below the vehicle's floor
constexpr double kHeight = 5.0;  // m from there to the top
constexpr double kAhead = 0.7;   // m
constexpr double kOther = 0.9;   // m about the other vehicle, in which its shadow lies
constexpr double kFull = 0.8;   // of a tile's half width; beyond, shadows fade, of what moves a little before
constexpr double kSoft = 0.05;  // m, by which a shadow is wider than what casts it

/// What OverheadShadow::mappingFrom() gives, from metres in the world's axes from the map's middle. Seen from
/// above the second runs against z, so that fronts stay fronts.
const glm::dmat4 kMapFromMiddle({1.0 / kHalf, 0.0, 0.0, 0.0},
                                {kShadowLean.x / kHalf, -kShadowLean.y / kHalf, 1.0 / kHeight, 0.0},
                                {0.0, -1.0 / kHalf, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0});

/// A box with all that is in its shadow down to a height.
WorldBox withShadow(WorldBox box, double down_to) {
  const double fall = std::max(box.high.y - down_to, 0.0);
  const Coord3 lean = fall * Coord3{kShadowLean.x, 0.0, kShadowLean.y};
  box.low += Coord3{std::min(lean.x, 0.0), 0.0, std::min(lean.z, 0.0)};
  box.high += Coord3{std::max(lean.x, 0.0), 0.0, std::max(lean.z, 0.0)};
  return box;
}

void makeMap(GLuint texture, const ShadowMapSize& size) {
  glTextureStorage2D(texture, 1, GL_DEPTH_COMPONENT32F, size.tiles * size.resolution, size.resolution);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(texture, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
}

}  // namespace

void OverheadShadow::check(const ShadowMapSize& size) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  limit /= size.tiles;
  if (size.resolution < 16 || size.resolution > limit)
    throw std::runtime_error("shadow resolution " + std::to_string(size.resolution) + " must be 16 to " +
                             std::to_string(limit) + " with this driver");
}

OverheadShadow::OverheadShadow(const ShadowMapSize& size, std::size_t moving_count)
    : resolution_(size.resolution),
      program_(makeProgram("shadow", kShadowVertexShader, kShadowFragmentShader)) {
  check(size);
  while (std::ssize(tiles_) < size.tiles) tiles_.emplace_back(moving_count);
  shading_.reserve(moving_count);
  makeMap(depth_.name(), size);
  glClearTexImage(depth_.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  glNamedFramebufferTexture(frame_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
  glNamedFramebufferDrawBuffer(frame_.name(), GL_NONE);
  glNamedFramebufferReadBuffer(frame_.name(), GL_NONE);
}

OverheadShadow::Tile::Tile(std::size_t moving_count)
    : commands(moving_count), matrices(moving_count * sizeof(glm::mat4)) {
  for (Casters* list : {&casters, &drawn}) {
    list->drawables.reserve(moving_count);
    list->map_from_mesh.reserve(moving_count);
  }
}

void OverheadShadow::Tile::place(const Coord3& middle, double texel) {
  floor_middle = {texel * std::round(middle.x / texel), middle.y, texel * std::round(middle.z / texel)};
  map_middle = floor_middle + kBelow * Coord3{kShadowLean.x, -1.0, kShadowLean.y};
}

WorldBox OverheadShadow::Tile::region() const {
  const Coord3 half{kHalf, 0.0, kHalf};
  return {floor_middle - half, floor_middle + half};
}

void OverheadShadow::Tile::add(const CompiledScene& scene, const Drawable& drawable,
                               const IndexRange& range) {
  const TransformMatrix& t_world_object = scene.worldTransform(drawable);
  casters.drawables.push_back({&drawable, range});
  casters.map_from_mesh.emplace_back(kMapFromMiddle * fromEye(map_middle, t_world_object, drawable.origin));
}

void OverheadShadow::placeTiles(const EyeView& view, const ViewPyramids& views) {
  const double texel = 2.0 * kHalf / resolution_;
  const Coord3 middle = view.t_world_vehicle.point({0.0, 0.0, -kAhead});
  tiles_[0].place(middle, texel);
  tile_count_ = 1;
  if (tiles_.size() < 2 || !view.t_world_other_vehicle) return;
  const Coord3 other = view.t_world_other_vehicle->origin();
  const glm::dvec3 away = glm::abs((other - middle).glm());
  if (std::max({away.x, away.y, away.z}) + kOther < kFull * kHalf) return;
  // Most of its shadow is to the side to which the light leans.
  tiles_[1].place(other + 0.5 * Coord3{kShadowLean.x, 0.0, kShadowLean.y}, texel);
  const Coord3 half{kHalf, 0.5 * kHeight, kHalf};
  const double leaning = kHeight * norm(Coord3{kShadowLean.x, 0.0, kShadowLean.y});
  const Sphere about{tiles_[1].map_middle + Coord3{0.0, half.y, 0.0}, norm(half) + leaning};
  if (views.sees(about) == InView::None) return;
  tile_count_ = 2;
}

void OverheadShadow::chooseCasters(const CompiledScene& scene, const Enclosures& enclosures,
                                   const DetailChoice& detail) {
  shading_.clear();
  for (Tile& tile : tiles_) {
    tile.casters.drawables.clear();
    tile.casters.map_from_mesh.clear();
  }
  for (const Drawable& drawable : scene.moving().drawables) {
    if (drawable.faces->material.emission >= kShines || turnOf(scene.worldTransform(drawable)) == Turn::Flat)
      continue;
    const WorldBox box = worldBox(scene, drawable);
    const double allowed = detail.allowedError(scene.worldSphere(drawable));
    const IndexRange range = scene.coarsestWithin(allowed, drawable);
    bool casts = false;
    for (std::size_t t = 0; t < tile_count_; ++t) {
      const WorldBox region = tiles_[t].region();
      if (!overlapFromAbove(withShadow(box, region.low.y), region)) continue;
      tiles_[t].add(scene, drawable, range);
      casts = true;
    }
    if (casts) shading_.push_back({box, enclosures.around(0.5 * (box.low + box.high))});
  }
}

void OverheadShadow::update(const CompiledScene& scene, const EyeView& view, const ViewPyramids& views,
                            const Enclosures& enclosures, const DetailChoice& detail) {
  placeTiles(view, views);
  chooseCasters(scene, enclosures, detail);
}

void OverheadShadow::draw(const CompiledScene& scene, const SceneBuffers& buffers) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glUseProgram(program_.name());
  buffers.bindMoving();
  glEnable(GL_SCISSOR_TEST);
  for (std::size_t t = 0; t < tile_count_; ++t)
    if (tiles_[t].casters != tiles_[t].drawn) drawTile(t, scene);
  glDisable(GL_SCISSOR_TEST);
}

void OverheadShadow::drawTile(std::size_t number, const CompiledScene& scene) {
  Tile& tile = tiles_[number];
  const int left = static_cast<int>(number) * resolution_;
  glViewport(left, 0, resolution_, resolution_);
  glScissor(left, 0, resolution_, resolution_);
  glClear(GL_DEPTH_BUFFER_BIT);
  tile.commands.begin();
  for (const auto& [drawable, range] : tile.casters.drawables)
    tile.commands.add(range, tile.commands.size(), turnOf(scene.worldTransform(*drawable)) == Turn::Mirrored);
  const std::vector<glm::mat4>& matrices = tile.casters.map_from_mesh;
  std::copy(matrices.begin(), matrices.end(), tile.matrices.next<glm::mat4>());
  tile.matrices.bind(GL_SHADER_STORAGE_BUFFER, 0);
  tile.commands.draw();
  std::swap(tile.casters, tile.drawn);
}

std::string OverheadShadow::explain() const {
  const std::string side = std::to_string(resolution_);
  return std::to_string(tiles_.size()) + " x " + side + " x " + side + " texels" +
         (tiles_.size() < 2 ? ", no second tile: there is no other vehicle" : "");
}

bool OverheadShadow::reaches(const WorldBox& box) const {
  const Coord3 soft{kSoft, 0.0, kSoft};
  const Coord3 middle = 0.5 * (box.low + box.high);
  return std::any_of(shading_.begin(), shading_.end(), [&](const Shading& caster) {
    return box.low.y < caster.box.high.y &&
           overlapFromAbove({box.low - soft, box.high + soft}, withShadow(caster.box, box.low.y)) &&
           (caster.room == nullptr || Enclosures::reaches(*caster.room, middle, box.high - middle));
  });
}

glm::mat4 OverheadShadow::mappingFrom(const Coord3& eye) const {
  return glm::mat4(kMapFromMiddle * fromEye(tiles_[0].map_middle, TransformMatrix::translation(eye), {}));
}

glm::vec3 OverheadShadow::toSecondTile() const {
  if (tile_count_ < 2) return glm::vec3(1e6F);
  const Coord3 step = tiles_[0].map_middle - tiles_[1].map_middle;
  return glm::vec3(glm::dmat3(kMapFromMiddle) * step.glm());
}

}  // namespace coherency
