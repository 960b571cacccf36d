#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/config/Endpoint.h"
#include "common/config/HmdProfile.h"
#include "common/wire/Key.h"

namespace coherency {

/// The command line and the HMD profile it names.
struct ClientOptions {
  Endpoint server;
  std::string eye = "both";  ///< left, right, both or mono
  bool window = false;
  bool fullscreen = false;
  int monitor = 0;
  int width = 640;  ///< of one eye's part of the display, pixels
  int height = 480;
  double render_scale = 1.0;  ///< of each side of the pictures drawn (PictureSize.h)
  int samples = 4;
  double detail_px = 0.25;   ///< RendererSettings
  double smallest_px = 0.0;  ///< likewise
  HmdProfile hmd;
  Key key = kNoKey;                   ///< the server's
  bool discover = false;              ///< say which servers there are, and end
  double fps = 0.0;                   ///< at most; 0: as the session has it
  double duration_s = 0.0;            ///< 0: until a signal or Esc
  std::uint64_t frames = 0;           ///< 0: no limit
  std::string snapshot_dir;           ///< empty: current folder for snapshots by key, none at the end
  std::vector<double> snapshot_at_s;  ///< session times of the pictures, rising; none: the last one drawn
  bool panel_snapshots = false;       ///< what the panels show, in place of what is seen
  std::string video;                  ///< file; empty: none
  std::string stats_json;
  bool explain = false;  ///< say what was compiled, and what was left out
  double wait_s = 10.0;  ///< for the server, at the start
};

/// As parseServerOptions(): `exit_code` is set where the program should end at once.
ClientOptions parseClientOptions(int argc, char** argv, int& exit_code);

}  // namespace coherency
