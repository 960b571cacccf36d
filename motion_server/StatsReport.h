#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/motion/PredictionScore.h"
#include "common/sync/DurationHistogram.h"
#include "common/world/WorldState.h"
#include "motion_server/broadcast/Broadcaster.h"

namespace coherency {

/// When frames are seen, as it is now.
struct ScheduleStatus {
  double hz = 0.0;           ///< frames a second, those left out for all not counted
  double margin_ms = 0.0;    ///< from a frame's moment to its being seen
  std::uint64_t stride = 1;  ///< every how many-th is drawn
};

/// How good prediction was, by DOF and horizon.
using PredictionReport = std::array<std::array<DofScore, kHorizons>, kDofCount>;

/// What a server knows of its own run.
struct ServerStats {
  std::string master;
  std::string scene;
  Mode mode = Mode::Operator;
  TaskClock task;
  double nominal_rate_hz = 0.0;
  double duration_s = 0.0;
  std::uint64_t samples = 0;
  std::uint64_t missed = 0;  ///< sampling periods that passed without a sample
  bool real_time = false;    ///< the sampling thread has real-time scheduling
  Spread period_jitter_us;   ///< how far the time between two samples was off the period
  Spread lateness_us;        ///< of a sample after its moment on the schedule
  std::array<std::uint64_t, kDofCount> refused{};  ///< values the master gave that were out of range, by DOF
  std::vector<ClientStatus> clients;               ///< connected, and the newest of those that have left
  std::uint64_t clients_served = 0;
  RejectCounts rejected;
  StereoStatus stereo;
  std::string encoding;  ///< of samples, and why that one
  ScheduleStatus frames;
  std::string prediction;      ///< its kind
  PredictionReport predicted;  ///< how good it was
};

/// One line for a terminal.
std::string statusLine(const ServerStats& stats);
/// All of it as JSON text; docs/statistics.md names the keys.
std::string statsJson(const ServerStats& stats);

}  // namespace coherency
