#include "motion_server/device/ReplayMaster.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

#include "motion_server/device/simulated/MinimumJerk.h"

namespace coherency {

namespace {

double mix(double a, double b, double s) {
  return a + (b - a) * s;
}
Coord3 mix(const Coord3& a, const Coord3& b, double s) {
  return a + (b - a) * s;
}

RecordedRow interpolate(const RecordedRow& a, const RecordedRow& b, double s) {
  RecordedRow row;
  row.head = mix(a.head, b.head, s);
  row.attitude = slerp(a.attitude, b.attitude, s);
  for (std::size_t j = 0; j < kArmJointCount; ++j) row.arm[j] = mix(a.arm[j], b.arm[j], s);
  row.grip = mix(a.grip, b.grip, s);
  row.stick = mix(a.stick, b.stick, s);
  row.pedal_left = mix(a.pedal_left, b.pedal_left, s);
  row.pedal_right = mix(a.pedal_right, b.pedal_right, s);
  return row;
}

MasterReading toReading(const RecordedRow& row) {
  MasterReading reading;
  const YawPitchRoll attitude = yawPitchRoll(rotation(row.attitude));
  reading.si = {row.head.x,    row.head.y,  row.head.z,     attitude.yaw,   attitude.pitch,
                attitude.roll, row.arm[0],  row.arm[1],     row.arm[2],     row.arm[3],
                row.arm[4],    row.arm[5],  row.arm[6],     row.grip,       row.stick.x,
                row.stick.y,   row.stick.z, row.pedal_left, row.pedal_right};
  return reading;
}

/// What the shift to the seat takes out of its DOF's range would be refused sample by sample, and the head
/// would stand.
void checkHead(const std::string& name, const RecordedRow& row, const Coord3& shift) {
  const Coord3 head = row.head + shift;
  const std::array<std::pair<Dof, double>, 3> values{
      {{Dof::HeadX, head.x}, {Dof::HeadY, head.y}, {Dof::HeadZ, head.z}}};
  for (const auto& [dof, value] : values) {
    if (value >= info(dof).min && value <= info(dof).max) continue;
    throw std::runtime_error(name + ": at " + std::to_string(static_cast<double>(row.time_ns) * 1e-9) +
                             " s the seated head's " + std::string(info(dof).name) + " is " +
                             std::to_string(value) + " m, out of its range " + std::to_string(info(dof).min) +
                             " to " + std::to_string(info(dof).max) + "; record nearer to the origin");
  }
}

}  // namespace

ReplayMaster::ReplayMaster(Recording recording, const Rig& rig, const ReplayOptions& options)
    : recording_(std::move(recording)), options_(options) {
  assert(!recording_.rows.empty());
  if (options_.head_height == HeadHeight::Seated) shift_ = neutralHead(rig) - recording_.rows.front().head;
  for (const RecordedRow& row : recording_.rows) checkHead(recording_.name, row, shift_);
}

RecordedRow ReplayMaster::at(std::int64_t time_ns) const {
  const auto& rows = recording_.rows;
  const auto after = std::upper_bound(rows.begin(), rows.end(), time_ns,
                                      [](std::int64_t t, const RecordedRow& row) { return t < row.time_ns; });
  if (after == rows.begin()) return rows.front();
  if (after == rows.end()) return rows.back();
  const RecordedRow& before = *(after - 1);
  const double s =
      static_cast<double>(time_ns - before.time_ns) / static_cast<double>(after->time_ns - before.time_ns);
  return interpolate(before, *after, s);
}

std::optional<MasterReading> ReplayMaster::read(std::int64_t elapsed_ns, const WorldState& /*world*/) {
  const std::int64_t duration = recording_.durationNs();
  const std::int64_t phase = options_.loop ? elapsed_ns % (duration + kLoopBlendNs) : elapsed_ns;
  if (phase > duration && !options_.loop) return std::nullopt;
  RecordedRow row = at(phase);
  if (phase > duration) {
    const double s = static_cast<double>(phase - duration) / static_cast<double>(kLoopBlendNs);
    row = interpolate(recording_.rows.back(), recording_.rows.front(), minimumJerk(s));
  }
  row.head += shift_;
  MasterReading reading = toReading(row);
  reading.valid = recording_.measured;
  reading.device_time_us = elapsed_ns / 1000;
  return reading;
}

}  // namespace coherency
