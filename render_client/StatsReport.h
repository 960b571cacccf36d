#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/sync/DurationHistogram.h"
#include "render_client/receive/ServerLink.h"

namespace coherency {

/// What a client knows of its own run.
struct ClientStats {
  std::string eye;
  std::string scene;
  std::string renderer;
  int width = 0;
  int height = 0;
  int samples = 0;
  std::uint64_t frames = 0;
  double fps = 0.0;             ///< over the whole run, from the first frame on
  double first_frame_ms = 0.0;  ///< from the program's start
  double motion_age_ms = 0.0;   ///< of the newest packet, now
  Spread frame_ms;              ///< drawing a picture until it is complete
  Spread motion_to_present_ms;  ///< sampling on the server to being presented here
  Spread late_ms;               ///< being presented after the frame's time
  std::uint64_t hash_mismatches = 0;
  std::uint64_t recompilations = 0;        ///< of the scene, each a hitch
  std::vector<std::string> found_to_move;  ///< paths of what moved without being declared Moving
  LinkStats link;
};

/// One line for a terminal.
std::string statusLine(const ClientStats& stats);
/// Several lines for the picture.
std::string overlayText(const ClientStats& stats);
/// All of it as JSON text; docs/statistics.md names the keys.
std::string statsJson(const ClientStats& stats);

}  // namespace coherency
