#include "bench/peers/PeerRun.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <time.h>

#include "bench/peers/PeerWorld.h"
#include "render_client/present/Png.h"

namespace coherency {
namespace {

using Steady = std::chrono::steady_clock;

double millisecondsSince(Steady::time_point begin) {
  return std::chrono::duration<double, std::milli>(Steady::now() - begin).count();
}

/// Of all threads.
double processorMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Options {
  int warm_up = 10;
  int frames = kPathFrames;
  int picture_frame = 20;
  bool update_only = false;
  std::string picture;
  std::string compare;
};

struct Times {
  std::vector<double> wall_ms;
  std::vector<double> cpu_ms;
  std::vector<double> update_ms;  ///< of the processor, too
};

void drawFrame(Peer& peer, int frame, Times* times = nullptr) {
  peer.prepare(frame);
  peer.finish();
  const double cpu = processorMilliseconds();
  const auto begin = Steady::now();
  peer.draw(frame);
  peer.finish();
  if (times == nullptr) return;
  times->wall_ms.push_back(millisecondsSince(begin));
  times->cpu_ms.push_back(processorMilliseconds() - cpu);
}

void updateFrame(Peer& peer, int frame, Times& times) {
  peer.prepare(frame);
  peer.finish();
  const double cpu = processorMilliseconds();
  peer.update(frame);
  times.update_ms.push_back(processorMilliseconds() - cpu);
}

/// How far two pictures are apart, in steps of 255 of the channel that is farthest.
nlohmann::json difference(const Image& image, const Image& other) {
  if (image.rgb.size() != other.rgb.size()) throw std::runtime_error("the pictures differ in size");
  int worst = 0;
  std::size_t differing = 0;  // pixels that somebody might see
  for (std::size_t pixel = 0; pixel < image.rgb.size(); pixel += 3) {
    int apart = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i)
      apart = std::max(apart, std::abs(image.rgb[i] - other.rgb[i]));
    worst = std::max(worst, apart);
    if (apart > 3) ++differing;
  }
  return {{"max", worst},
          {"share_above_3", 3.0 * static_cast<double>(differing) / static_cast<double>(image.rgb.size())}};
}

nlohmann::json run(const Options& options, const std::function<std::unique_ptr<Peer>()>& make,
                   Steady::time_point start) {
  const std::unique_ptr<Peer> peer = make();
  drawFrame(*peer, 0);
  nlohmann::json result{{"startup_ms", millisecondsSince(start)}};
  if (!options.picture.empty() || !options.compare.empty()) {
    drawFrame(*peer, options.picture_frame);
    const Image image = peer->picture();
    if (!options.picture.empty()) writePng(options.picture, image);
    if (!options.compare.empty()) result["difference"] = difference(image, readPng(options.compare));
  }
  Times times;
  for (int frame = 0; frame < options.warm_up; ++frame) drawFrame(*peer, frame);
  const auto place = [&](int i) { return i * kPathFrames / options.frames; };
  if (!options.update_only)
    for (int i = 0; i < options.frames; ++i) drawFrame(*peer, place(i), &times);
  for (int i = 0; i < options.frames; ++i) {
    if (!options.update_only) drawFrame(*peer, place(i));
    updateFrame(*peer, place(i + 1), times);
  }
  result["wall_ms"] = times.wall_ms;
  result["cpu_ms"] = times.cpu_ms;
  result["update_ms"] = times.update_ms;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  result["peak_mib"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return result;
}

}  // namespace

int runPeer(CLI::App& app, int argc, char** argv, const std::function<std::unique_ptr<Peer>()>& make) {
  const auto start = Steady::now();
  Options options;
  app.add_option("--warm-up", options.warm_up, "Frames before the clock runs")->capture_default_str();
  app.add_option("--frames", options.frames, "Of which the times are printed, spread over the path")
      ->capture_default_str();
  app.add_flag("--update-only", options.update_only, "Draw no frames but those to warm up");
  app.add_option("--picture", options.picture, "PNG file for the picture of a frame");
  app.add_option("--compare", options.compare, "PNG file of another peer's picture of it");
  app.add_option("--picture-frame", options.picture_frame, "Which frame")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::printf("%s\n", run(options, make, start).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), error.what());
    return 1;
  }
  return 0;
}

}  // namespace coherency
