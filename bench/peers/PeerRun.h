#pragma once

#include <functional>
#include <memory>

#include <CLI/CLI.hpp>

#include "render_client/draw/Image.h"

namespace coherency {

/// Somebody who draws a scene along its path, into a target of kPeerWidth x kPeerHeight with kPeerSamples.
class Peer {
 public:
  Peer() = default;
  virtual ~Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// Before the clock runs.
  virtual void prepare(int) {}
  /// All that the processor does for a frame before the GPU draws: moves what moves, finds out what is in
  /// view, and writes down what to draw.
  virtual void update(int frame) = 0;
  /// The whole frame, update() too.
  virtual void draw(int frame) = 0;
  /// Returns when the GPU is done.
  virtual void finish() = 0;
  virtual Image picture() = 0;
};

/// Times it, and prints the figures as JSON: wall and processor time of each frame; processor time of
/// update() alone, each after another frame was drawn; ms. Start-up, from the start of the program to the end
/// of the first frame; the peak of its memory. Adds its options to the program's own. Returns the program's
/// exit status.
int runPeer(CLI::App& app, int argc, char** argv, const std::function<std::unique_ptr<Peer>()>& make);

}  // namespace coherency
