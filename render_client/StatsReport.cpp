#include "render_client/StatsReport.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coherency {
namespace {

nlohmann::ordered_json json(const Spread& s) {
  return {{"p50", s.p50}, {"p99", s.p99}, {"max", s.max}};
}

std::string clockText(const LinkStats& link) {
  if (!link.clock_known) return "clock unknown";
  return fmt::format("clock {:+.0f} +-{:.0f} us", static_cast<double>(link.clock_offset_ns) / 1e3,
                     static_cast<double>(link.clock_bound_ns) / 1e3);
}

}  // namespace

std::string statusLine(const ClientStats& stats) {
  const std::string eye = stats.eye == "both" ? "both eyes" : stats.eye + " eye";
  if (!stats.link.connected)
    return fmt::format("{}: no server for {:.1f} s, holding the last pose", eye, stats.motion_age_ms / 1e3);
  return fmt::format("{}: {:.1f} fps, frame {:.1f} ms, motion to picture {:.1f} ms, lost {}, {}", eye,
                     stats.fps, stats.frame_ms.p50, stats.motion_to_present_ms.p50, stats.link.lost,
                     clockText(stats.link));
}

std::string overlayText(const ClientStats& stats) {
  return fmt::format(
      "{} eye  {}  {:.1f} fps\nframe {:.1f} ms  motion to picture {:.1f} ms\n"
      "packets {}  lost {}  recovered {}\n{}{}",
      stats.eye, stats.scene, stats.fps, stats.frame_ms.p50, stats.motion_to_present_ms.p50,
      stats.link.received, stats.link.lost, stats.link.recovered, clockText(stats.link),
      stats.recompilations == 0 ? "" : fmt::format("\nscene compiled again {} times", stats.recompilations));
}

std::string statsJson(const ClientStats& stats) {
  const LinkStats& link = stats.link;
  nlohmann::ordered_json all = {{"eye", stats.eye},
                                {"scene", stats.scene},
                                {"size", {stats.width, stats.height}},
                                {"msaa_samples", stats.samples},
                                {"frames", stats.frames},
                                {"fps", stats.fps},
                                {"first_frame_ms", stats.first_frame_ms},
                                {"frame_ms", json(stats.frame_ms)},
                                {"motion_to_present_ms", json(stats.motion_to_present_ms)},
                                {"late_ms", json(stats.late_ms)},
                                {"motion_age_ms", stats.motion_age_ms},
                                {"connections", link.connections},
                                {"packets",
                                 {{"received", link.received},
                                  {"lost", link.lost},
                                  {"recovered", link.recovered},
                                  {"reordered", link.reordered},
                                  {"rejected", link.rejected},
                                  {"forged", link.forged},
                                  {"replayed", link.replayed},
                                  {"without_keyframe", link.without_keyframe}}},
                                {"way", kMotionWayNames[static_cast<std::size_t>(link.way)]},
                                {"replica",
                                 {{"hash_mismatches", stats.hash_mismatches},
                                  {"keyframes", link.keyframes},
                                  {"differing_field", link.differing_field}}},
                                {"recompilations", stats.recompilations},
                                {"found_to_move", stats.found_to_move},
                                {"renderer", stats.renderer}};
  if (link.clock_known)
    all["clock"] = {{"offset_us", static_cast<double>(link.clock_offset_ns) / 1e3},
                    {"bound_us", static_cast<double>(link.clock_bound_ns) / 1e3},
                    {"skew_ppm", link.clock_skew_ppm}};
  return all.dump(2, ' ', false, decltype(all)::error_handler_t::replace) + "\n";
}

}  // namespace coherency
