#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/motion/ErrorHistogram.h"
#include "common/motion/MotionSample.h"

namespace coherency {

/// Horizons are scored apart: up to 10, 20, 40 ms, and beyond.
inline constexpr std::array<double, 3> kHorizonEdgesMs = {10.0, 20.0, 40.0};
inline constexpr std::size_t kHorizons = kHorizonEdgesMs.size() + 1;
std::size_t horizonIndex(std::int64_t horizon_ns);

/// How well one DOF was predicted; errors in SI (m, rad, ratio), to 6.3 %.
struct DofScore {
  std::uint64_t count = 0;
  double median = 0.0, p95 = 0.0;            ///< of |predicted - came|
  double held_median = 0.0, held_p95 = 0.0;  ///< of |held - came|: what no prediction would have been off
  double worse = 0.0;  ///< share of predictions that were farther from what came than holding was
  double gain = 1.0;   ///< gain()
};

/// Compares predictions with what then came, between the two samples about the time they were made for. A DOF
/// is scored where it is valid in these two and was when predicted. Nothing is scored over a gap in motion
/// (intervalSeconds() in DofMotion.h). Memory is fixed: of more than kPending predictions under way at a time
/// the rest goes unscored.
class PredictionScore {
 public:
  static constexpr std::size_t kPending = 64;
  static constexpr double kMemoryS = 5.0;  ///< with which gains forget

  /// `raw` was predicted `horizon_ns` from `base`, the newest sample; `given` is what was made of it and is
  /// scored.
  void predicted(const MotionSample& base, const MotionSample& raw, const MotionSample& given,
                 std::int64_t horizon_ns);
  void arrived(const MotionSample& sample);

  /// By which the predictor's travel would have come nearest to what came: recursive least squares that
  /// forget, each weighted by 1 / (|travel predicted| + |travel that came|), so that single glitches do not
  /// decide. Within 0 to 1: 1 where prediction is right or short, 0 where it says nothing; 1 before anything
  /// was scored.
  double gain(Dof dof, std::size_t horizon) const;
  DofScore report(Dof dof, std::size_t horizon) const;
  std::uint64_t unscored() const { return unscored_; }

 private:
  using Units = std::array<std::int32_t, kDofCount>;
  struct Pending {
    std::int64_t for_time_ns;
    std::size_t horizon;
    DofMask valid;
    Units held, raw, given;
  };
  struct Record {
    ErrorHistogram error, held_error;
    std::uint64_t worse = 0;
    double raw_raw = 0.0, raw_came = 0.0;  ///< weighted sums of products of travels, in units
    std::int64_t last_ns = 0;              ///< of the newest in the sums
  };
  void score(const Pending& p, const MotionSample& after);
  static void add(Record& record, Dof dof, const Pending& p, double came);

  std::array<Pending, kPending> pending_{};
  std::size_t count_ = 0;
  MotionSample newest_;
  std::array<std::array<Record, kDofCount>, kHorizons> records_{};
  std::uint64_t unscored_ = 0;
};

}  // namespace coherency
