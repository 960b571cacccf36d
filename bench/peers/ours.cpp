// This project's renderer among its peers.
#include <epoxy/gl.h>

#include "bench/peers/PeerRun.h"
#include "bench/peers/PeerWorld.h"
#include "render_client/draw/Renderer.h"
#include "render_client/present/Display.h"

namespace {

using namespace coherency;

class Ours : public Peer {
 public:
  explicit Ours(const PeerWorldOptions& options)
      : display_(makeHeadlessDisplay({.width = kPeerWidth, .height = kPeerHeight})),
        world_(options),
        renderer_(world_.root(), world_.illumination(), kPeerWidth, kPeerHeight,
                  {.samples = kPeerSamples, .shadows = false, .detail_px = 0.0, .bake = options.bake}) {}

  void prepare(int frame) override { poses_ = world_.poses(frame); }
  void update(int frame) override {
    world_.move(poses_);
    const EyeView view = world_.view(frame);
    renderer_.prepare({&view, 1});
  }
  void draw(int frame) override {
    world_.move(poses_);
    const EyeView view = world_.view(frame);
    renderer_.draw({&view, 1});
  }
  void finish() override { glFinish(); }
  Image picture() override { return renderer_.readImage(); }

 private:
  std::unique_ptr<Display> display_;
  PeerWorld world_;
  Renderer renderer_;
  std::vector<TransformMatrix> poses_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times this project's renderer on a scene.", "peer_ours");
  PeerWorldOptions options;
  options.addTo(app);
  return runPeer(app, argc, argv, [&] { return std::make_unique<Ours>(options); });
}
