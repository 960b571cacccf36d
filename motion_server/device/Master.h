#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/motion/SampleGate.h"
#include "common/world/WorldState.h"

namespace coherency {

/// Whatever measures the operator's 19 DOFs: hardware, a recording, a program. One thread reads it, once a
/// sampling period; read() must not block.
class Master {
 public:
  virtual ~Master() = default;
  virtual std::string name() const = 0;
  /// The posture at `elapsed_ns` since the session began, in SI. `world` is what an operator would see;
  /// hardware takes no notice of it. nullopt: the master has ended (a recording that does not loop).
  virtual std::optional<MasterReading> read(std::int64_t elapsed_ns, const WorldState& world) = 0;
};

}  // namespace coherency
