#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "common/body/ArmKinematics.h"
#include "common/math/Rotation.h"
#include "common/motion/MotionSample.h"

namespace coherency {

/// One row of a recording, in SI: head centre in the body frame's axes, head to body attitude, arm joints,
/// controls.
struct RecordedRow {
  std::int64_t time_ns = 0;  ///< since the first row
  Coord3 head;
  Quaternion attitude;
  ArmJoints arm{};
  double grip = 0.0;
  Coord3 stick;  ///< x, y, twist
  double pedal_left = 0.0;
  double pedal_right = 0.0;
};

/// Human motion from a CSV file: the header kRecordingHeader, then one row a sample at any rate, even or not,
/// times strictly increasing. Columns the source did not measure are 0 in every row.
struct Recording {
  std::string name;               ///< the file's
  std::vector<RecordedRow> rows;  ///< at least one
  DofMask measured = 0;           ///< DOFs the source has; the arm counts as a whole

  std::int64_t durationNs() const { return rows.back().time_ns; }
};

extern const std::string kRecordingHeader;

/// Throws std::runtime_error "file:line:column: what is wrong and what would be right" for a file that cannot
/// be read, other columns, text or NaN or an infinity for a number, time that does not go on, a quaternion
/// whose length is off 1 by more than 1e-3, a value out of its DOF's range, or no rows.
Recording readRecording(const std::string& path);
/// The same from a stream; `name` stands for the file in errors.
Recording parseRecording(std::istream& in, const std::string& name);

}  // namespace coherency
