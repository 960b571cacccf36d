#include "render_client/Options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/config/CommandLine.h"
#include "common/config/ConfigError.h"
#include "common/config/KeyFile.h"
#include "common/config/ReplaceFile.h"
#include "common/wire/Packets.h"
#include "render_client/present/Video.h"

namespace coherency {
namespace {

void parseSize(const std::string& text, int& width, int& height) {
  const auto x = text.find('x');
  const auto number = [&](std::string_view part) {
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    const bool whole = error == std::errc{} && end == part.data() + part.size();
    if (!whole || value < 16 || value > 16384)
      throw ConfigError(
          fmt::format("--size {}: must be WIDTHxHEIGHT, each from 16 to 16384, as 640x480", text));
    return value;
  };
  const std::string_view all = text;
  width = number(all.substr(0, x));
  height = number(x == std::string::npos ? std::string_view{} : all.substr(x + 1));
}

void takeSize(const std::string& text, ClientOptions& options) {
  const HmdProfile& hmd = options.hmd;
  if (!text.empty()) {
    parseSize(text, options.width, options.height);
  } else if (hmd.panel) {
    options.width = hmd.panel->width;
    options.height = hmd.panel->height;
  } else if (hmd.screen) {  // of the screen's shape
    const auto height =
        static_cast<int>(std::lround(options.width * hmd.screen->height_m / hmd.screen->width_m));
    options.height = std::clamp(height, 16, 16384);
  }
}

void checkVideo(const std::string& path) {
  if (path.empty()) return;
  if (!path.ends_with(".mp4")) throw ConfigError(fmt::format("--video {}: must end in .mp4", path));
  if (ffmpegPath().empty())
    throw ConfigError(
        "--video: needs the program ffmpeg, which is not in PATH; install it: apt-get install ffmpeg");
  checkReplaceable("--video", path);
}

bool hasDisplay() {
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0';
}

/// The command line's part that is looked at before it is an option.
struct Texts {
  std::string server = "127.0.0.1", key_file, display, size, hmd, snapshot_of;
  bool insecure = false;
};

void declare(CLI::App& app, Texts& texts, ClientOptions& options) {
  app.add_option("--server", texts.server, "HOST:PORT of the motion server [127.0.0.1:7430]");
  app.add_flag("--discover", options.discover, "list the servers on this network and end");
  app.add_option("--key", texts.key_file, "file with the server's key, copied from there");
  app.add_flag("--insecure", texts.insecure,
               "join a server on another machine without a key: whoever is in between can pretend to be it");
  app.add_option("--eye", options.eye, "left, right, both (side by side) or mono [both]")
      ->check(CLI::IsMember({"left", "right", "both", "mono"}));
  app.add_option("--display", texts.display, "window or headless [window where there is a display]")
      ->check(CLI::IsMember({"window", "headless"}));
  app.add_option(
      "--size", texts.size,
      "WxH of one eye's part of the display in pixels [the panel's of the HMD profile, else 640x480]");
  app.add_option("--render-scale", options.render_scale,
                 "pictures are drawn with as many times the pixels to each side, 0.25 to 4 [1]")
      ->check(finite(0.25, 4.0));
  app.add_flag("--fullscreen", options.fullscreen, "fill a monitor; implies --display window");
  app.add_option("--monitor", options.monitor, "which monitor, counted from 0 [0]")->check(whole(0, 63));
  app.add_option("--hmd", texts.hmd,
                 fmt::format("HMD profile: one of {}, or a TOML file [generic]", hmdNames()));
  app.add_option("--samples", options.samples, "samples a pixel for antialiasing, 1 to 16 [4]")
      ->check(whole(1, 16));
  app.add_option("--detail-px", options.detail_px,
                 "draw curved things coarser where that moves their edges by no more pixels than this, 0 to "
                 "100; 0: never; the same for both eyes [0.25]")
      ->check(finite(0.0, 100.0));
  app.add_option("--smallest-px", options.smallest_px,
                 "leave out what is smaller across than so many pixels, 0 to 100; the same for both eyes [0: "
                 "nothing]")
      ->check(finite(0.0, 100.0));
  app.add_option("--fps", options.fps,
                 "frames a second, about and at most, 1 to 1000: every second one is drawn, or third ... "
                 "[the session's]")
      ->check(finite(1.0, 1000.0));
  app.add_option("--duration", options.duration_s, "end after this many seconds [0: until Ctrl-C or Esc]")
      ->check(finite(0.0, 1e9));
  app.add_option("--frames", options.frames, "end after this many frames [0: no limit]")
      ->check(whole(0, 1'000'000'000'000));
  app.add_option("--snapshot-dir", options.snapshot_dir,
                 "write EYE.png here at the end, and snapshots by key");
  app.add_option(
         "--snapshot-at", options.snapshot_at_s,
         "seconds of session time at which EYE.png is taken [the last frame]; several, as 5,10,20, give "
         "EYE_1.png, EYE_2.png ...")
      ->delimiter(',')
      ->check(finite(0.0, 1e9));
  app.add_option("--snapshot-of", texts.snapshot_of,
                 "what snapshots and video show where the HMD has lenses: view, as it is seen through them, "
                 "or panel, as the window has it [view]")
      ->check(CLI::IsMember({"view", "panel"}));
  app.add_option("--video", options.video,
                 "write a film of the whole run to this .mp4 file, both eyes side by side; needs ffmpeg");
  app.add_option("--stats-json", options.stats_json, "write statistics to this file, anew twice a second");
  app.add_flag("--explain", options.explain,
               "print what of the scene was compiled, what was left out and why, and what it takes");
  app.add_option("--wait", options.wait_s, "seconds to wait for the server at the start [10]")
      ->check(finite(0.0, 1e6));
  app.set_version_flag("--version", COHERENCY_VERSION);
}

void takeServer(const Texts& texts, ClientOptions& options) {
  options.server = parseEndpoint(texts.server, kDefaultPort);
  if (!texts.key_file.empty()) options.key = readKeyFile(texts.key_file);
  const bool here = options.server.host == "localhost" || isLoopback(options.server.host);
  if (!here && texts.key_file.empty() && !texts.insecure)
    throw ConfigError(fmt::format(
        "--server {}: another machine needs a key; copy the server's key file here and give --key FILE, "
        "or give --insecure where the server has none",
        texts.server));
}

void take(const Texts& texts, ClientOptions& options) {
  if (!options.discover) takeServer(texts, options);
  if (!texts.hmd.empty()) options.hmd = readHmdProfile(texts.hmd);
  takeSize(texts.size, options);
  options.panel_snapshots = texts.snapshot_of == "panel";
  checkVideo(options.video);
  std::sort(options.snapshot_at_s.begin(), options.snapshot_at_s.end());
  if (options.fullscreen && texts.display == "headless")
    throw ConfigError("--fullscreen and --display headless exclude each other: give one of them");
  const bool asked = options.fullscreen || texts.display == "window";
  if (asked && !hasDisplay())
    throw ConfigError(
        fmt::format("{}: there is no display to open a window on, as DISPLAY is not set; log in at "
                    "the screen, or give --display headless",
                    options.fullscreen ? "--fullscreen" : "--display window"));
  options.window = asked || (texts.display.empty() && hasDisplay());
  checkReplaceable("--stats-json", options.stats_json);
}

}  // namespace

ClientOptions parseClientOptions(int argc, char** argv, int& exit_code) {
  ClientOptions options;
  Texts texts;
  CLI::App app{"Draws one eye (or both) of the virtual human a motion server drives."};
  declare(app, texts, options);
  exit_code = parseArguments(app, argc, argv, "render_client");
  if (exit_code >= 0) return options;
  try {
    take(texts, options);
  } catch (const ConfigError& e) {
    fmt::print(stderr, "render_client: {}\n", e.what());
    exit_code = 2;
  }
  return options;
}

}  // namespace coherency
