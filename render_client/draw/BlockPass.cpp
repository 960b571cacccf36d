#include "render_client/draw/BlockPass.h"

#include "render_client/draw/ShaderProgram.h"

namespace coherency {
namespace {

std::vector<Sphere> spheresOf(const std::vector<Block>& blocks) {
  std::vector<Sphere> spheres;
  spheres.reserve(blocks.size());
  for (const Block& block : blocks) spheres.push_back({block.origin, block.radius});
  return spheres;
}

Program program(const char* name, const ShaderVariant& variant) {
  return makeProgram(name, fixedVertexShader(variant), fragmentShader(variant));
}

}  // namespace

BlockPass::BlockPass(const std::vector<Block>& blocks, LightSource light, int shadow_resolution)
    : blocks_(blocks),
      plain_program_(program("fixed", {.light = light})),
      shaded_program_(program("fixed, in shadow", {.light = light, .shadow_resolution = shadow_resolution})),
      plain_(blocks.size()),
      shaded_(blocks.size()),
      spheres_(spheresOf(blocks)),
      order_(blocks.size()),
      offsets_(blocks.size()),
      offset_buffer_(GL_SHADER_STORAGE_BUFFER, offsets_.size() * sizeof(glm::vec4)) {
  seen_.reserve(blocks.size());
  for (const Block& block : blocks) boxes_.push_back(worldBox(block));
}

void BlockPass::begin(const Coord3& eye, std::size_t view_count, const ViewPyramids& views,
                      const Enclosures& enclosures, const OverheadShadow* shadow) {
  offset_buffer_.reserve(view_count);
  seen_.clear();
  spheres_.findSeen(views, seen_);
  std::erase_if(seen_,
                [&](std::uint32_t i) { return enclosures.hide(blocks_[i].origin, blocks_[i].half_extent); });
  order_.clear();
  for (const std::uint32_t i : seen_) order_.add(i, farthest(boxes_[i], eye));
  order_.sort();
  plain_.clear();
  shaded_.clear();
  for (const NearestFirst::Shown& shown : order_.shown()) {
    const Block& block = blocks_[shown.number];
    const bool in_shadow = shadow != nullptr && block.shaded && shadow->reaches(boxes_[shown.number]);
    (in_shadow ? shaded_ : plain_).add(block.range, shown.number, false);
  }
  plain_.upload();
  shaded_.upload();
}

void BlockPass::draw(std::size_t slot, const Coord3& eye) {
  for (const std::uint32_t i : seen_)
    offsets_[i] = glm::vec4(glm::dvec4((blocks_[i].origin - eye).glm(), 0.0));
  offset_buffer_.write(slot, offsets_.data(), offsets_.size() * sizeof(glm::vec4));
  offset_buffer_.bind(slot, 0);
  glUseProgram(shaded_program_.name());
  shaded_.draw();
  glUseProgram(plain_program_.name());
  plain_.draw();
}

}  // namespace coherency
