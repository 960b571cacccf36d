#include "motion_server/StatsReport.h"

#include <algorithm>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coherency {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Spread& s) {
  return {{"p50", s.p50}, {"p99", s.p99}, {"max", s.max}};
}

double rate(const ServerStats& stats) {
  return stats.duration_s > 0.0 ? static_cast<double>(stats.samples) / stats.duration_s : 0.0;
}

Json client(const ClientStatus& c) {
  return {{"id", c.id},
          {"address", c.address},
          {"eye", c.eye},
          {"way", c.way},
          {"connected", c.connected},
          {"packets_sent", c.packets_sent},
          {"packets_not_sent", c.packets_not_sent},
          {"packets_received", c.last_report.packets_received},
          {"packets_lost", c.last_report.packets_lost}};
}

Json stereo(const StereoStatus& s) {
  DurationHistogram skew;
  for (const std::int64_t ns : s.present_skew_ns) skew.add(std::abs(ns));
  const Spread skew_us = spread(skew, 1e3);
  return {{"frames_compared", s.frames_compared},
          {"frames_agreeing", s.frames_agreeing},
          {"agreement", s.agreement()},
          {"differing", {{"tick", s.other_tick}, {"state", s.other_state}}},
          {"one_eye_only",
           {{"input_late", s.input_late},
            {"drawing_late", s.drawing_late},
            {"mismatch", s.mismatch},
            {"lost", s.lost}}},
          {"present_skew_us", {{"p50", skew_us.p50}, {"p99", skew_us.p99}}}};
}

/// Session time in seconds, or null for a tick that has not come.
Json seconds(std::uint64_t tick, const ServerStats& stats) {
  return tick == 0 ? Json() : Json(static_cast<double>(tick) / stats.nominal_rate_hz);
}

Json task(const ServerStats& stats) {
  return {{"started_s", seconds(stats.task.started_tick, stats)},
          {"tower_s", seconds(stats.task.done_tick, stats)},
          {"towers", stats.task.towers}};
}

/// In mm, degrees and hundredths.
double perceived(Dof dof, double si) {
  switch (info(dof).kind) {
    case DofKind::Length:
      return si * 1e3;
    case DofKind::Angle:
      return si * 180.0 / std::numbers::pi;
    case DofKind::Ratio:
      return si * 100.0;
  }
  return si;
}

Json score(Dof dof, const DofScore& s) {
  return {{"count", s.count},
          {"median", perceived(dof, s.median)},
          {"p95", perceived(dof, s.p95)},
          {"held_median", perceived(dof, s.held_median)},
          {"held_p95", perceived(dof, s.held_p95)},
          {"worse", s.worse},
          {"gain", s.gain}};
}

Json prediction(const ServerStats& stats) {
  Json dofs = Json::object();
  for (std::size_t i = 0; i < kDofCount; ++i)
    for (std::size_t h = 0; h < kHorizons; ++h) {
      const DofScore& s = stats.predicted[i][h];
      if (s.count == 0) continue;
      const std::string horizon =
          h < kHorizonEdgesMs.size() ? fmt::format("to_{:.0f}_ms", kHorizonEdgesMs[h]) : "beyond";
      dofs[std::string(dofTable()[i].name)][horizon] = score(dofAt(i), s);
    }
  return {{"kind", stats.prediction}, {"dofs", dofs}};
}

Json refusedByDof(const ServerStats& stats) {
  Json refused = Json::object();
  for (std::size_t i = 0; i < kDofCount; ++i)
    if (stats.refused[i] > 0) refused[std::string(dofTable()[i].name)] = stats.refused[i];
  return refused;
}

}  // namespace

std::string statusLine(const ServerStats& stats) {
  const auto connected = std::count_if(stats.clients.begin(), stats.clients.end(),
                                       [](const ClientStatus& c) { return c.connected; });
  const StereoStatus& stereo = stats.stereo;
  const std::string agreement =
      stereo.frames_compared == 0
          ? ""
          : fmt::format(", eyes agree on {} of {} frames, seen after {:.0f} ms", stereo.frames_agreeing,
                        stereo.frames_compared + stereo.oneEyed(), stats.frames.margin_ms);
  return fmt::format("{}: {:.1f} s, {:.0f} Hz, jitter p99 {:.0f} us, {} clients now, {} served{}",
                     stats.master, stats.duration_s, rate(stats), stats.period_jitter_us.p99, connected,
                     stats.clients_served, agreement);
}

std::string statsJson(const ServerStats& stats) {
  Json clients = Json::array();
  for (const ClientStatus& c : stats.clients) clients.push_back(client(c));
  const RejectCounts& r = stats.rejected;
  const Json all = {
      {"master", stats.master},
      {"scene", stats.scene},
      {"mode", stats.mode == Mode::Robot ? "robot" : "operator"},
      {"task", task(stats)},
      {"nominal_rate_hz", stats.nominal_rate_hz},
      {"rate_hz", rate(stats)},
      {"duration_s", stats.duration_s},
      {"samples", stats.samples},
      {"missed", stats.missed},
      {"real_time", stats.real_time},
      {"period_jitter_us", json(stats.period_jitter_us)},
      {"lateness_us", json(stats.lateness_us)},
      {"refused_values", refusedByDof(stats)},
      {"clients", clients},
      {"clients_served", stats.clients_served},
      {"rejected",
       {{"malformed", r.malformed},
        {"foreign", r.foreign},
        {"oversized", r.oversized},
        {"version", r.version},
        {"forged", r.forged},
        {"replayed", r.replayed}}},
      {"encoding", stats.encoding},
      {"frames",
       {{"hz", stats.frames.hz}, {"margin_ms", stats.frames.margin_ms}, {"stride", stats.frames.stride}}},
      {"prediction", prediction(stats)},
      {"stereo", stereo(stats.stereo)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace coherency
