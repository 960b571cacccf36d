// The floor under all peers: the triangles that show, found beforehand, in one bare multi-draw for each of
// the three shaders.
#include <cstddef>

#include <glm/gtc/type_ptr.hpp>

#include "bench/peers/FloorBatches.h"
#include "bench/peers/FloorShaders.h"
#include "bench/peers/PeerRun.h"
#include "bench/peers/PeerScene.h"
#include "bench/peers/PeerWorld.h"
#include "render_client/compile/ToneCurve.h"
#include "render_client/draw/RenderTarget.h"
#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"
#include "render_client/draw/ViewUniforms.h"
#include "render_client/present/Display.h"

namespace {

using namespace coherency;

FloorPass fixedPass(LightSource light, const VertexLayout& layout) {
  const bool mapped = light == LightSource::Lightmap;
  return {makeProgram("fixed", bareVertexShader(mapped, false), fragmentShader({.light = light})),
          makeProgram("marking", bareVertexShader(mapped, true), kMarkingFragmentShader), layout, 1};
}

FloorPass movingPass(const PeerScene& scene) {
  const ShaderVariant variant{LightSource::Lamps, scene.lamp_count, {}};
  return {makeProgram("moving", movingVertexShader(variant), fragmentShader(variant)),
          makeProgram("marking", movingVertexShader({LightSource::Lamps, scene.lamp_count, {}, true}),
                      kMarkingFragmentShader),
          {sizeof(MeshVertex), 3, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, normal), 0},
          scene.moving.size()};
}

class Floor : public Peer {
 public:
  Floor(const std::string& file, bool all_in_view)
      : display_(makeHeadlessDisplay({.width = kPeerWidth, .height = kPeerHeight})),
        scene_(readPeerScene(file)),
        all_in_view_(all_in_view),
        target_(kPeerWidth, kPeerHeight, kPeerSamples),
        lit_(fixedPass(LightSource::Vertices, {sizeof(LitVertex), 4, GL_UNSIGNED_SHORT, GL_TRUE,
                                               offsetof(LitVertex, light), offsetof(LitVertex, material)})),
        mapped_(fixedPass(LightSource::Lightmap,
                          {sizeof(MappedVertex), 2, GL_FLOAT, GL_FALSE, offsetof(MappedVertex, place),
                           offsetof(MappedVertex, material)})),
        moving_(movingPass(scene_)) {
    FloorPass::fill(moving_.vertices, scene_.moving_vertices);
    makeLightmap();
    setState();
  }

  void prepare(int frame) override {
    const EyeView& view = scene_.views[static_cast<std::size_t>(frame) % scene_.views.size()];
    if (scene_.on_the_way)
      for (std::size_t i = 0; i < scene_.moving.size(); ++i)
        scene_.moving[i].t_world_mesh = movingPose(i, scene_.moving.size(), frame);
    setView(view);
    auto lit = fixedInView(scene_.lit, view);
    auto mapped = fixedInView(scene_.mapped, view);
    MovingBatch moving = movingInView(scene_, view);
    setFixed(lit_, lit);
    setFixed(mapped_, mapped);
    FloorPass::fill(moving_.objects, moving.objects);
    FloorPass::fill(lamps_, moving.lamp_sets);
    moving_.set(std::move(moving.batch));
    if (all_in_view_) return;
    markShown();
    lit.batch = lit_.marked();
    mapped.batch = mapped_.marked();
    setFixed(lit_, lit);
    setFixed(mapped_, mapped);
    moving_.set(moving_.marked());
  }
  void update(int) override {}
  void draw(int) override {
    begin();
    moving_.draw();
    lit_.draw();
    mapped_.draw();
  }
  void finish() override { glFinish(); }
  Image picture() override {
    target_.resolve();
    Image image = target_.read();
    glDisable(GL_FRAMEBUFFER_SRGB);
    return image;
  }

 private:
  void setState() {
    const glm::vec3 sky(scene_.ambient.sky.glm());
    glClearColor(encoded(tone(sky.r)), encoded(tone(sky.g)), encoded(tone(sky.b)), 1.0F);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glClearDepth(0.0);
    glEnable(GL_CULL_FACE);
    glEnable(GL_MULTISAMPLE);
    glViewport(0, 0, kPeerWidth, kPeerHeight);
  }

  void makeLightmap() {
    if (scene_.lightmap.empty()) return;
    const GLuint texture = lightmap_.name();
    glTextureStorage2D(texture, 1, GL_RGBA16, scene_.lightmap_size.x, scene_.lightmap_size.y);
    glTextureSubImage2D(texture, 0, 0, 0, scene_.lightmap_size.x, scene_.lightmap_size.y, GL_RGBA,
                        GL_UNSIGNED_SHORT, scene_.lightmap.data());
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTextureUnit(1, texture);
  }

  void setView(const EyeView& view) {
    uniforms_.write({&view, 1}, view.t_world_eye.origin(), scene_.ambient, nullptr);
    const glm::mat4 to_clip(projection(view.view, view.near_m).glm() *
                            view.t_world_eye.linear().rigidInverse().glm());
    for (const FloorPass* pass : {&lit_, &mapped_})
      for (const Program* program : {&pass->program, &pass->marking})
        glProgramUniformMatrix4fv(program->name(), 0, 1, GL_FALSE, glm::value_ptr(to_clip));
  }

  template <class Vertex>
  static void setFixed(FloorPass& pass, FixedBatch<Vertex>& made) {
    compact(made);
    FloorPass::fill(pass.vertices, made.vertices);
    pass.set(made.batch);
  }

  /// Marks the triangles that win a sample, or tie with one that does: once the depths are those of the whole
  /// picture, their fragments alone have them.
  void markShown() {
    begin();
    for (const GLenum which : {GL_GREATER, GL_EQUAL}) {
      glDepthFunc(which);
      for (const FloorPass* pass : {&moving_, &lit_, &mapped_}) pass->mark();
    }
    glDepthFunc(GL_GREATER);
  }

  void begin() {
    target_.bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    uniforms_.bind(0);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, lamps_.name());
  }

  std::unique_ptr<Display> display_;
  PeerScene scene_;
  bool all_in_view_;
  RenderTarget target_;
  ViewUniforms uniforms_;
  FloorPass lit_;
  FloorPass mapped_;
  Texture lightmap_;
  FloorPass moving_;
  Buffer lamps_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times one bare multi-draw of the triangles that show.", "peer_floor");
  std::string file;
  bool all_in_view = false;
  app.add_option("file", file, "Of peer_export")->required();
  app.add_flag("--all-in-view", all_in_view, "Those too that face away or that others hide");
  return runPeer(app, argc, argv, [&] { return std::make_unique<Floor>(file, all_in_view); });
}
