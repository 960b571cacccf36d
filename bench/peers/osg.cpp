// OpenSceneGraph among its peers: one thread, as what is timed is one frame from its begin to its end, in
// which none of its threading models has anything to do beside.
#include <map>

#include <osg/ClipControl>
#include <osg/Depth>
#include <osgUtil/Optimizer>
#include <osgUtil/SceneView>

#include "bench/peers/OsgGraph.h"
#include "bench/peers/OsgTarget.h"
#include "bench/peers/PeerRun.h"
#include "bench/peers/PeerWorld.h"
#include "render_client/compile/ToneCurve.h"

namespace {

using namespace coherency;

struct OsgSettings {
  std::string optimizer = "none";
  OsgBuffers buffers = OsgBuffers::Vbo;
  bool front_to_back = false;
};

/// none; default: the optimiser's own choice; cells: what stands together is put together first, some 200 to
/// a cell, so that what is merged can be culled.
void optimize(osg::Group& root, const std::string& how) {
  using O = osgUtil::Optimizer;
  O optimizer;
  if (how == "default") optimizer.optimize(&root, O::DEFAULT_OPTIMIZATIONS);
  if (how != "cells") return;
  optimizer.optimize(&root,
                     O::FLATTEN_STATIC_TRANSFORMS | O::REMOVE_REDUNDANT_NODES | O::SHARE_DUPLICATE_STATE);
  O::SpatializeGroupsVisitor cells;
  root.accept(cells);
  cells.divide(200);
  optimizer.optimize(&root, O::MERGE_GEOMETRY | O::MAKE_FAST_GEOMETRY | O::REMOVE_REDUNDANT_NODES);
}

class Osg : public Peer {
 public:
  Osg(const std::string& file, const OsgSettings& settings)
      : scene_(readPeerScene(file)),
        target_(kPeerWidth, kPeerHeight, kPeerSamples),
        graph_(scene_, settings.buffers),
        view_(new osgUtil::SceneView) {
    optimize(*graph_.root, settings.optimizer);
    if (settings.front_to_back)
      osgUtil::RenderBin::setDefaultRenderBinSortMode(osgUtil::RenderBin::SORT_FRONT_TO_BACK);
    osg::StateSet* state = graph_.root->getOrCreateStateSet();
    state->setAttributeAndModes(
        new osg::ClipControl(osg::ClipControl::LOWER_LEFT, osg::ClipControl::ZERO_TO_ONE));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::GREATER));
    setUpView();
  }

  void prepare(int frame) override {
    if (!scene_.on_the_way) return;
    poses_.clear();
    for (std::size_t i = 0; i < scene_.moving.size(); ++i)
      poses_.push_back(movingPose(i, scene_.moving.size(), frame));
  }
  void update(int frame) override {
    for (std::size_t i = 0; i < poses_.size(); ++i) graph_.moving[i]->setMatrix(osgMatrix(poses_[i]));
    const EyeView& view = scene_.views[static_cast<std::size_t>(frame) % scene_.views.size()];
    graph_.setEye(scene_, view.t_world_eye);
    view_->setProjectionMatrix(osgMatrix(projection(view.view, view.near_m)));
    view_->setViewMatrix(osgMatrix(view.t_world_eye.rigidInverse()));
    stamp_->setFrameNumber(stamp_->getFrameNumber() + 1);
    view_->update();
    view_->cull();
  }
  void draw(int frame) override {
    update(frame);
    target_.bind();
    view_->draw();
  }
  void finish() override { target_.finish(); }
  Image picture() override { return target_.read(); }

 private:
  void setUpView() {
    view_->setDefaults(osgUtil::SceneView::NO_SCENEVIEW_LIGHT);
    osg::State& state = *view_->getState();
    state.setContextID(osg::GraphicsContext::createNewContextID());
    state.setCheckForGLErrors(osg::State::NEVER_CHECK_GL_ERRORS);
    view_->setFrameStamp(stamp_);
    view_->setSceneData(graph_.root);
    view_->setViewport(0, 0, kPeerWidth, kPeerHeight);
    osg::Camera& camera = *view_->getCamera();
    camera.setDrawBuffer(GL_COLOR_ATTACHMENT0);
    camera.setReadBuffer(GL_COLOR_ATTACHMENT0);
    const glm::vec3 sky(scene_.ambient.sky.glm());
    camera.setClearColor({encoded(tone(sky.r)), encoded(tone(sky.g)), encoded(tone(sky.b)), 1.0F});
    camera.setClearDepth(0.0);
    camera.setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (osg::CullSettings* settings :
         {static_cast<osg::CullSettings*>(&camera), static_cast<osg::CullSettings*>(view_.get())}) {
      settings->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
      settings->setCullingMode(osg::CullSettings::VIEW_FRUSTUM_SIDES_CULLING);
    }
  }

  PeerScene scene_;
  OsgTarget target_;
  OsgGraph graph_;
  osg::ref_ptr<osgUtil::SceneView> view_;
  osg::ref_ptr<osg::FrameStamp> stamp_ = new osg::FrameStamp;
  std::vector<TransformMatrix> poses_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times OpenSceneGraph on a scene of peer_export's.", "peer_osg");
  std::string file;
  OsgSettings settings;
  app.add_option("file", file, "Of peer_export")->required();
  app.add_option("--optimizer", settings.optimizer, "none, default or cells")
      ->check(CLI::IsMember({"none", "default", "cells"}))
      ->capture_default_str();
  const std::map<std::string, OsgBuffers> kinds{
      {"vbo", OsgBuffers::Vbo}, {"vao", OsgBuffers::Vao}, {"lists", OsgBuffers::Lists}};
  app.add_option("--buffers", settings.buffers, "vbo, vao or (display) lists")
      ->transform(CLI::CheckedTransformer(kinds));
  app.add_flag("--front-to-back", settings.front_to_back, "Sort by distance instead of by state");
  return runPeer(app, argc, argv, [&] { return std::make_unique<Osg>(file, settings); });
}
