#include "render_client/draw/DrawnScene.h"

#include <algorithm>

namespace coherency {

DrawnScene::DrawnScene(const VRObject& root, const Illumination& illumination,
                       const RendererSettings& settings, const ObjectSet& found_to_move)
    : settings_(settings),
      ambient_(illumination.ambient),
      compiled_(root, illumination, settings.bake, found_to_move),
      buffers_(compiled_),
      lamps_(illumination, compiled_),
      enclosures_(compiled_.enclosures()) {
  if (settings.shadows) OverheadShadow::check({settings.shadow_resolution, 2});  // something may move later
  const ShadowMapSize shadows = shadowMap();
  const FixedBlocks& fixed = compiled_.fixed();
  const std::size_t moving_count = compiled_.moving().drawables.size();
  if (moving_count > 0)
    moving_.emplace(compiled_, std::min(illumination.lamps.size(), kChosenLamps), shadows);
  if (!fixed.lit.blocks.empty()) lit_.emplace(fixed.lit.blocks, LightSource::Vertices, shadows);
  if (!fixed.mapped.blocks.empty()) mapped_.emplace(fixed.mapped.blocks, LightSource::Lightmap, shadows);
  if (shadows.resolution > 0) shadow_.emplace(shadows, moving_count);
}

ShadowMapSize DrawnScene::shadowMap() const {
  const bool none = !settings_.shadows || compiled_.moving().drawables.empty();
  return {none ? 0 : settings_.shadow_resolution, settings_.two_vehicles ? 2 : 1};
}

void DrawnScene::prepare(std::span<const EyeView> views) {
  compiled_.repaint([&](const VRObject& object) { buffers_.rewrite(compiled_.fixed(), object); });
  compiled_.update();
  clipTo(views);
  if (views.empty()) return;
  const Coord3 origin = views.front().t_world_eye.origin();
  const DetailChoice detail = detailFor(views.front());
  if (shadow_) shadow_->update(compiled_, views.front(), pyramids_, enclosures_, detail);
  const OverheadShadow* const map = shadow_ ? &*shadow_ : nullptr;
  lamps_.update();
  uniforms_.write(views, origin, ambient_, map);
  if (moving_) moving_->begin(compiled_, lamps_, origin, pyramids_, enclosures_, detail);
  if (lit_) lit_->begin(origin, pyramids_, enclosures_, detail, map);
  if (mapped_) mapped_->begin(origin, pyramids_, enclosures_, detail, map);
}

void DrawnScene::clipTo(std::span<const EyeView> views) {
  pyramids_.clear();
  enclosures_.begin();
  if (!settings_.clip) return;
  for (const EyeView& view : views) {
    pyramids_.add({view.t_world_eye, view.view, view.near_m});
    const double pixel = std::max((view.view.tan_left + view.view.tan_right) / view.width,
                                  (view.view.tan_down + view.view.tan_up) / view.height);
    enclosures_.addView(view.t_world_eye, view.view, view.near_m, pixel);
  }
}

DetailChoice DrawnScene::detailFor(const EyeView& view) const {
  if (!view.cyclopean) return {};
  return {*view.cyclopean, settings_.detail_px, settings_.smallest_px};
}

void DrawnScene::drawShadows() {
  if (shadow_) shadow_->draw(compiled_, buffers_);
}

void DrawnScene::draw(std::span<const EyeView> views, const IdPicture* instead) const {
  if (shadow_) shadow_->bindTexture();
  for (std::size_t i = 0; i < views.size(); ++i) {
    uniforms_.bind(i);
    glViewport(views[i].x, views[i].y, views[i].width, views[i].height);
    drawView(instead);
  }
}

void DrawnScene::drawView(const IdPicture* instead) const {
  const auto program = [&](LightSource light) {
    return instead == nullptr ? nullptr : &instead->program(light);
  };
  if (moving_) moving_->draw(buffers_, program(LightSource::Lamps));
  if (mapped_) {
    buffers_.bindMapped();
    mapped_->draw(program(LightSource::Lightmap));
  }
  if (lit_) {  // the sky is among it: behind everything
    buffers_.bindLit();
    lit_->draw(program(LightSource::Vertices));
  }
}

IdImage DrawnScene::drawIds(std::span<const EyeView> views, int width, int height) {
  const auto pass = [](const auto& of) { return of ? &*of : nullptr; };
  if (!ids_) ids_.emplace(compiled_);
  ids_->begin(width, height);
  draw(views, &*ids_);
  return ids_->read(pass(moving_), pass(lit_), pass(mapped_));
}

FrameCounts DrawnScene::counts() const {
  FrameCounts counts;
  if (moving_) {
    counts.moving = moving_->count();
    counts.triangles = moving_->triangleCount();
  }
  for (const std::optional<BlockPass>* pass : {&lit_, &mapped_}) {
    if (!*pass) continue;
    counts.fixed_shaded += (*pass)->shadedCount();
    counts.fixed_plain += (*pass)->plainCount();
    counts.triangles += (*pass)->triangleCount();
  }
  return counts;
}

std::string DrawnScene::explain() const {
  std::string text = describe(compiled_.report());
  const auto line = [&](const char* what, const std::string& how) {
    text += what + std::string(16 - std::string(what).size(), ' ') + how + "\n";
  };
  if (shadow_)
    line("shadow map", shadow_->explain());
  else
    line("shadow map",
         moving_ ? "none: switched off" : "none, and no shader that looks in one: nothing moves");
  if (!moving_) line("moving things", "no shader, and no lamps to choose: there are none");
  if (moving_ && compiled_.report().lamps == 0)
    line("lamps", "none in the shader of what moves: there are none");
  if (!lit_) line("lit at vertices", "no shader: nothing is");
  if (!mapped_) line("lit by lightmap", "no shader, no texture: nothing is");
  return text;
}

}  // namespace coherency
