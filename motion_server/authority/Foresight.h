#pragma once

#include <cstdint>

#include "common/motion/DampedPredictor.h"
#include "common/wire/Packets.h"
#include "common/world/World.h"

namespace coherency {

struct ForesightConfig {
  PredictorConfig prediction;
  std::int64_t period_ns = 1'000'000;
  bool compact = false;  ///< samples have to be such as the compact encoding can tell
};

/// Says what a frame shows: the world as it will be when the frame is seen. The master's DOFs are predicted
/// from the samples until now, and the world is stepped on with them, so that who drives towards a wall is
/// not seen in it. It happens once, at the server, where nothing is lost: clients draw what they are told,
/// and no two can predict differently.
class Foresight {
 public:
  /// `world` outlives this.
  Foresight(const ForesightConfig& config, const World& world);

  /// Each sample, in order: what is predicted from, and what earlier predictions are scored by.
  void add(const MotionSample& sample);
  /// What frame `number` shows at `seen`, as it is foreseen from the newest sample and the state it was
  /// stepped into. Without prediction that state itself. Precondition: a sample was added.
  FrameState frame(std::uint64_t number, const WorldState& world, ServerTime seen);

  const PredictionScore& score() const { return predictor_.score(); }

 private:
  void stepOn(WorldState& world, const MotionSample& sample, std::int64_t ahead_ns) const;

  ForesightConfig config_;
  const World& world_;
  DampedPredictor predictor_;
  MotionSample newest_;
};

}  // namespace coherency
