#include "render_client/Options.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/config/CommandLine.h"
#include "common/config/ConfigError.h"
#include "common/config/ReplaceFile.h"

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

bool hasDisplay() {
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0';
}

/// The command line's part that is looked at before it is an option.
struct Texts {
  std::string server = "127.0.0.1", display, size, hmd;
};

void declare(CLI::App& app, Texts& texts, ClientOptions& options) {
  app.add_option("--server", texts.server, "HOST:PORT of the motion server [127.0.0.1:7430]");
  app.add_option("--eye", options.eye, "left, right, both (side by side) or mono [both]")
      ->check(CLI::IsMember({"left", "right", "both", "mono"}));
  app.add_option("--display", texts.display, "window or headless [window where there is a display]")
      ->check(CLI::IsMember({"window", "headless"}));
  app.add_option("--size", texts.size, "WxH of one eye's picture in pixels [640x480]");
  app.add_flag("--fullscreen", options.fullscreen, "fill a monitor; implies --display window");
  app.add_option("--monitor", options.monitor, "which monitor, counted from 0 [0]")->check(whole(0, 63));
  app.add_option("--hmd", texts.hmd,
                 fmt::format("HMD profile: one of {}, or a TOML file [generic]", hmdNames()));
  app.add_option("--samples", options.samples, "samples a pixel for antialiasing, 1 to 16 [4]")
      ->check(whole(1, 16));
  app.add_option("--fps", options.fps, "frames a second at most, 1 to 1000 [the monitor's; headless 62.5]")
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
  app.add_option("--stats-json", options.stats_json, "write statistics to this file, anew twice a second");
  app.add_option("--wait", options.wait_s, "seconds to wait for the server at the start [10]")
      ->check(finite(0.0, 1e6));
  app.set_version_flag("--version", COHERENCY_VERSION);
}

void take(const Texts& texts, ClientOptions& options) {
  options.server = parseEndpoint(texts.server, 7430);
  if (!texts.size.empty()) parseSize(texts.size, options.width, options.height);
  if (!texts.hmd.empty()) options.hmd = readHmdProfile(texts.hmd);
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
