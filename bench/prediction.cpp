// Prediction of the master's DOFs against recordings of people: how far off at 10, 20, 40 and 80 ms, held, at
// constant velocity, by the filter, and by the filter as far as it was right of late. One run, one table.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/PredictionErrors.h"
#include "common/motion/DampedPredictor.h"

namespace {

using namespace coherency;

struct Way {
  const char* name;
  Prediction method;
  bool damped;
};
constexpr std::array<Way, 4> kWays = {{{"none", Prediction::None, false},
                                       {"velocity", Prediction::Velocity, false},
                                       {"kalman", Prediction::Kalman, false},
                                       {"damped", Prediction::Kalman, true}}};
constexpr std::array<double, 4> kHorizonsMs = {10.0, 20.0, 40.0, 80.0};
/// Recordings on which KalmanPredictor's figures were chosen; only the others say how good it is.
constexpr std::array<std::string_view, 4> kChosenOn = {"cmu_13_26_direct_traffic", "cmu_14_12_wash_window",
                                                       "cmu_29_07_hand_signals", "hmd_vivepro2_b"};
using Table = std::array<std::array<PredictionErrors, kWays.size()>, kHorizonsMs.size()>;

Table evaluate(const std::vector<MotionSample>& samples) {
  Table table;
  for (std::size_t h = 0; h < kHorizonsMs.size(); ++h)
    for (std::size_t w = 0; w < kWays.size(); ++w)
      table[h][w] = predictionErrors(samples, kWays[w].method, kWays[w].damped, kHorizonsMs[h]);
  return table;
}

/// Median, 95 % point, and the share that was worse than holding.
void print(const std::string& name, const Table& table) {
  fmt::print("\n{}\n| ms | of | {} | {} | {} | {} |\n|---|---|---|---|---|---|\n", name, kWays[0].name,
             kWays[1].name, kWays[2].name, kWays[3].name);
  for (std::size_t h = 0; h < kHorizonsMs.size(); ++h)
    for (std::size_t g = 0; g < kErrorGroups; ++g) {
      const auto group = static_cast<ErrorGroup>(g);
      if (table[h][0].off[g].empty()) continue;
      fmt::print("| {:.0f} | {} |", kHorizonsMs[h], kErrorGroupNames[g]);
      for (std::size_t w = 0; w < kWays.size(); ++w) {
        const PredictionErrors& e = table[h][w];
        fmt::print(" {:.2f}, {:.2f}", e.quantile(group, 0.5), e.quantile(group, 0.95));
        if (w > 0) fmt::print(" ({:.0f} %)", 100.0 * e.worseShare(group));
        fmt::print(" |");
      }
      fmt::print("\n");
    }
}

/// Nanoseconds of one add() and of one predictFor() after each.
void printCost(const std::vector<MotionSample>& samples) {
  using Time = std::chrono::steady_clock;
  const auto ns = [&](Time::time_point from) {
    const std::chrono::duration<double, std::nano> spent = Time::now() - from;
    return spent.count() / static_cast<double>(samples.size());
  };
  fmt::print("\ncost of a sample, of a sample and a prediction, ns:\n");
  for (const Way& way : {kWays[0], kWays[1], kWays[2]}) {
    std::array<double, 2> least{1e18, 1e18};
    for (int round = 0; round < 5; ++round) {
      DampedPredictor adding({way.method, 60.0}), predicting({way.method, 60.0});
      const auto start = Time::now();
      for (const MotionSample& sample : samples) adding.add(sample);
      least[0] = std::min(least[0], ns(start));
      const auto again = Time::now();
      for (const MotionSample& sample : samples) {
        predicting.add(sample);
        predicting.predictFor(sample.server_time_ns + 40'000'000);
      }
      least[1] = std::min(least[1], ns(again));
    }
    fmt::print("{:<9} {:6.0f} {:6.0f}\n", way.name, least[0], least[1]);
  }
}

std::vector<std::filesystem::path> recordingsIn(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    // Head and hand without arm joints: no master has these columns.
    if (entry.path().extension() == ".csv" &&
        entry.path().stem().string().find("_headhand") == std::string::npos)
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void run(const std::string& folder, Sampled sampled) {
  Table others;
  std::vector<MotionSample> samples;
  const auto files = recordingsIn(folder);
  if (files.empty()) throw std::runtime_error(folder + ": has no recording, NAME.csv");
  for (const auto& file : files) {
    samples = samplesOf(readRecording(file.string()), sampled);
    const Table table = evaluate(samples);
    print(file.stem().string(), table);
    const std::string name = file.stem().string();
    if (std::find(kChosenOn.begin(), kChosenOn.end(), name) != kChosenOn.end()) continue;
    for (std::size_t h = 0; h < kHorizonsMs.size(); ++h)
      for (std::size_t w = 0; w < kWays.size(); ++w) others[h][w].append(table[h][w]);
  }
  print("all but those that the filter was chosen on", others);
  printCost(samples);
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder = COHERENCY_MOTION_DATA;
  bool rows = false;
  CLI::App app{
      "Prediction against recordings of people: median and 95 % point of the error, and in brackets the "
      "share "
      "of predictions that were farther off than holding."};
  app.add_option("folder", folder, "with recordings [" + folder + "]");
  app.add_flag("--rows", rows,
               "samples are the recordings' rows; else every millisecond, as the server plays them");
  CLI11_PARSE(app, argc, argv);
  try {
    run(folder, rows ? Sampled::Rows : Sampled::EveryMillisecond);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_prediction: %s\n", error.what());
    return 1;
  }
  return 0;
}
