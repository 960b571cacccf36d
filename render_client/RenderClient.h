#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/sync/Clock.h"
#include "render_client/FramePacing.h"
#include "render_client/Options.h"
#include "render_client/Overlay.h"
#include "render_client/StatsReport.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/draw/Renderer.h"
#include "render_client/present/Display.h"
#include "render_client/present/Video.h"
#include "render_client/receive/ServerLink.h"
#include "render_client/replica/Replica.h"

namespace coherency {

/// A render client as a whole: receive -> replica -> draw -> present, frame by frame.
///
/// What is drawn, and when it is to be seen, each frame says itself (FrameState): the eyes of one session
/// show the same moments at the same time without talking to each other.
class RenderClient {
 public:
  /// Waits for the server and its first motion, then opens the display. Throws std::runtime_error with place
  /// and remedy.
  RenderClient(const ClientOptions& options, const Clock& clock);

  /// Draws until Ctrl-C, the window is closed, or the duration or number of frames is reached.
  /// `onStatus` is called twice a second. Throws std::runtime_error when a picture asked for could not be
  /// taken.
  void run(const std::function<void(const ClientStats&)>& onStatus);
  /// With what is known at this moment.
  ClientStats stats() const;
  /// What of the scene was compiled and what was left out (Renderer::explain()).
  std::string explain() const { return renderer_->explain(); }

 private:
  void awaitMotion(ClientTime deadline);
  void planPictures();
  void keepPlanned();
  void buildWorld(const SessionConfig& session);
  void beginFrames();
  void followSession();
  std::optional<ReceivedFrame> plannedFrame() const;
  void fitPictures();
  void drawFrame(const ReceivedFrame& frame, bool is_picture);
  void drawAgain();
  void drawViews();
  void present();
  void noteFoundToMove();
  void countPicture();
  void takeSnapshots(bool is_picture);
  Image snapshot();
  void addToVideo(std::uint64_t number);
  void endVideo();
  void showText();
  void handleInput();
  void switchMode();
  void takeWhatIsLeft();
  void writeLastPicture();
  void writeSnapshot(const std::string& name);
  void trySnapshotByKey();
  bool finished() const;
  ClientTime now() const { return {clock_.nowNs()}; }

  ClientOptions options_;
  const Clock& clock_;
  ClientTime started_;
  ServerLink link_;
  FramePacing pacing_;
  std::unique_ptr<Display> display_;
  EyeChoice eyes_;
  struct PlannedPicture {
    double session_s;
    std::string name;
  };
  std::deque<PlannedPicture> planned_;  ///< still to be drawn and written, earliest first
  std::optional<Replica> replica_;
  std::optional<Renderer> renderer_;
  std::vector<EyeView> views_;
  PanelSize display_size_;  ///< one eye's part of it, pixels
  PanelSize picture_;       ///< that is drawn for an eye
  std::optional<Video> video_;
  std::string video_fault_;  ///< what ended it before its time
  ClientTime newest_arrived_;
  std::optional<ClientTime> first_frame_;
  ClientTime last_frame_;
  Overlay overlay_;
  bool closed_ = false;
  bool snapshot_due_ = false;
  int snapshots_ = 0;
  std::uint64_t frames_ = 0;
  std::uint64_t recompilations_ = 0;
  std::vector<std::string> found_to_move_;  ///< paths, as they were found
};

}  // namespace coherency
