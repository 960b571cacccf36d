#include "render_client/draw/BlockPass.h"

#include "render_client/draw/ShaderProgram.h"

namespace coherency {
namespace {

Sphere sphereOf(const Block& block) {
  return {block.origin, block.radius};
}

std::vector<Sphere> spheresOf(const std::vector<Block>& blocks) {
  std::vector<Sphere> spheres;
  spheres.reserve(blocks.size());
  for (const Block& block : blocks) spheres.push_back(sphereOf(block));
  return spheres;
}

Program program(const char* name, const ShaderVariant& variant) {
  return makeProgram(name, fixedVertexShader(variant), fragmentShader(variant));
}

}  // namespace

BlockPass::BlockPass(const std::vector<Block>& blocks, LightSource light, const ShadowMapSize& shadows)
    : blocks_(blocks),
      plain_program_(program("fixed", {.light = light})),
      plain_(blocks.size()),
      shaded_(blocks.size()),
      spheres_(spheresOf(blocks)),
      order_(blocks.size()),
      offsets_(blocks.size() * sizeof(glm::vec4)) {
  if (shadows.resolution > 0)
    shaded_program_ = program("fixed, in shadow", {.light = light, .shadows = shadows});
  seen_.reserve(blocks.size());
  for (const Block& block : blocks) boxes_.push_back(worldBox(block));
}

IndexRange BlockPass::rangeOf(const Block& block) const {
  return coarsestWithin(detail_.allowedError(sphereOf(block)), block.range, block.coarser);
}

void BlockPass::begin(const Coord3& origin, const ViewPyramids& views, const Enclosures& enclosures,
                      const DetailChoice& detail, const OverheadShadow* shadow) {
  detail_ = detail;
  seen_.clear();
  spheres_.findSeen(views, seen_);
  order_.clear();
  for (const std::uint32_t i : seen_)
    if (!detail.tooSmall(sphereOf(blocks_[i])) && !enclosures.hide(blocks_[i].origin, blocks_[i].half_extent))
      order_.add(i, farthest(boxes_[i], origin));
  order_.sort();
  plain_.begin();
  shaded_.begin();
  auto* offset = offsets_.next<glm::vec4>();
  std::size_t place = 0;
  for (const NearestFirst::Shown& shown : order_.shown()) {
    const Block& block = blocks_[shown.number];
    const bool in_shadow = shadow != nullptr && block.shaded && shadow->reaches(boxes_[shown.number]);
    offset[place] = glm::vec4(glm::dvec4((block.origin - origin).glm(), 0.0));
    (in_shadow ? shaded_ : plain_).add(rangeOf(block), place++);
  }
}

void BlockPass::draw(const Program* instead) const {
  offsets_.bind(GL_SHADER_STORAGE_BUFFER, 0);
  if (shaded_program_) {
    glUseProgram((instead == nullptr ? *shaded_program_ : *instead).name());
    shaded_.draw();
  }
  glUseProgram((instead == nullptr ? plain_program_ : *instead).name());
  plain_.draw();
}

}  // namespace coherency
