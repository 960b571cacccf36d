#pragma once

#include "common/body/Rig.h"
#include "motion_server/device/Master.h"
#include "motion_server/device/Recording.h"

namespace coherency {

/// Seated: the recorded head is moved, as a whole path, so that its first sample is where the rig's head is
/// when sitting upright; recordings are of standing people while the rig sits. Recorded: taken as it is.
enum class HeadHeight { Seated, Recorded };

struct ReplayOptions {
  bool loop = true;  ///< go from the end to the start over kLoopBlendNs and begin again; false: end
  HeadHeight head_height = HeadHeight::Seated;
};

/// Plays a recording on the session's time: lengths, joints and ratios linear between rows, attitude by
/// slerp. DOFs the recording lacks are not valid, so that the neutral posture holds. device_time_us runs with
/// the recording and, when looping, on through the repetitions.
class ReplayMaster final : public Master {
 public:
  static constexpr std::int64_t kLoopBlendNs = 1'000'000'000;

  /// Precondition: the recording has a row. Throws std::runtime_error when the shifted head leaves its DOFs'
  /// range.
  ReplayMaster(Recording recording, const Rig& rig, const ReplayOptions& options = {});

  std::string name() const override { return "replay of " + recording_.name; }
  std::optional<MasterReading> read(std::int64_t elapsed_ns, const WorldState& world) override;

 private:
  RecordedRow at(std::int64_t time_ns) const;

  Recording recording_;
  ReplayOptions options_;
  Coord3 shift_;
};

}  // namespace coherency
