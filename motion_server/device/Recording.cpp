#include "motion_server/device/Recording.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace coherency {

const std::string kRecordingHeader =
    "t_s,head_x_m,head_y_m,head_z_m,head_qw,head_qx,head_qy,head_qz,arm_j1_rad,arm_j2_rad,arm_j3_rad,arm_j4_"
    "rad,"
    "arm_j5_rad,arm_j6_rad,arm_j7_rad,grip,joy_x,joy_y,joy_yaw,pedal_l,pedal_r";

namespace {

constexpr std::size_t kColumns = 21;
constexpr std::size_t kTime = 0, kHead = 1, kAttitude = 4, kArm = 8, kGrip = 15, kStick = 16, kPedals = 19;
constexpr double kLongest = 1e7;           // s
constexpr double kLengthTolerance = 1e-3;  // of a quaternion

struct Field {
  std::string_view text;
  std::size_t column;  // of its first character, from 1
};

/// Where in the file we are, for errors.
struct Place {
  const std::string& name;
  std::size_t line;
  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw std::runtime_error(name + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + what);
  }
};

std::vector<Field> split(std::string_view line) {
  std::vector<Field> fields;
  for (std::size_t start = 0;;) {
    const std::size_t comma = line.find(',', start);
    fields.push_back({line.substr(start, comma - start), start + 1});
    if (comma == std::string_view::npos) return fields;
    start = comma + 1;
  }
}

const std::vector<Field>& columnNames() {
  static const std::vector<Field> names = split(kRecordingHeader);
  return names;
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

bool nextLine(std::istream& in, std::string& line, std::size_t& count) {
  while (std::getline(in, line)) {
    ++count;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) return true;
  }
  return false;
}

void checkHeader(const std::string& line, const Place& place) {
  if (line == kRecordingHeader) return;
  if (line.find("hand_x_m") != std::string::npos) {
    place.fail(1,
               "this is a head-and-hand recording without arm joints; give the file of the same name without "
               "'_headhand', whose columns are " +
                   kRecordingHeader);
  }
  const std::vector<Field> found = split(line);
  for (std::size_t i = 0; i < kColumns; ++i) {
    if (i >= found.size()) {
      place.fail(line.size() + 1, "the column '" + std::string(columnNames()[i].text) +
                                      "' is missing; the header must be " + kRecordingHeader);
    }
    if (found[i].text != columnNames()[i].text) {
      place.fail(found[i].column, "column " + std::to_string(i + 1) + " is '" +
                                      std::string(found[i].text.substr(0, 40)) + "', must be '" +
                                      std::string(columnNames()[i].text) + "'; the header must be " +
                                      kRecordingHeader);
    }
  }
  place.fail(found[kColumns].column,
             "there are " + std::to_string(found.size()) + " columns, must be " + std::to_string(kColumns));
}

double toNumber(const Field& field, std::string_view column_name, const Place& place) {
  double value = 0.0;
  const char* end = field.text.data() + field.text.size();
  const auto result = std::from_chars(field.text.data(), end, value);
  if (result.ec == std::errc() && result.ptr == end && std::isfinite(value)) return value;
  place.fail(field.column, std::string(column_name) + " is '" + std::string(field.text.substr(0, 40)) +
                               "', must be a finite number such as 0.125");
}

using Numbers = std::array<double, kColumns>;

void checkRange(const Numbers& v, const std::vector<Field>& fields, std::size_t column, Dof dof,
                const Place& place) {
  const DofInfo& limit = info(dof);
  if (v[column] >= limit.min && v[column] <= limit.max) return;
  place.fail(fields[column].column, std::string(columnNames()[column].text) + " is " + number(v[column]) +
                                        ", must be within " + number(limit.min) + " to " + number(limit.max) +
                                        " " + std::string(unitName(limit.kind)));
}

Numbers readNumbers(const std::string& line, const Place& place) {
  const std::vector<Field> fields = split(line);
  if (fields.size() != kColumns) {
    place.fail(
        fields.size() > kColumns ? fields[kColumns].column : line.size() + 1,
        "there are " + std::to_string(fields.size()) + " columns, must be " + std::to_string(kColumns));
  }
  Numbers v{};
  for (std::size_t i = 0; i < kColumns; ++i) v[i] = toNumber(fields[i], columnNames()[i].text, place);
  if (std::abs(v[kTime]) > kLongest) place.fail(1, "t_s is " + number(v[kTime]) + ", must be within +-1e7 s");
  for (std::size_t i = 0; i < 3; ++i) checkRange(v, fields, kHead + i, dofAt(i), place);
  for (std::size_t i = kArm; i < kColumns; ++i) {
    checkRange(v, fields, i, dofAt(index(Dof::ShoulderFlexion) + i - kArm), place);
  }
  const double length =
      std::hypot(std::hypot(v[kAttitude], v[kAttitude + 1]), std::hypot(v[kAttitude + 2], v[kAttitude + 3]));
  if (std::abs(length - 1.0) > kLengthTolerance) {
    place.fail(fields[kAttitude].column,
               "the quaternion head_qw..head_qz has length " + number(length) + ", must be 1 within 0.001");
  }
  return v;
}

RecordedRow toRow(const Numbers& v, double first_time) {
  RecordedRow row;
  row.time_ns = std::llround((v[kTime] - first_time) * 1e9);
  row.head = {v[kHead], v[kHead + 1], v[kHead + 2]};
  row.attitude = normalized(Quaternion{v[kAttitude + 1], v[kAttitude + 2], v[kAttitude + 3], v[kAttitude]});
  for (std::size_t j = 0; j < kArmJointCount; ++j) row.arm[j] = v[kArm + j];
  row.grip = v[kGrip];
  row.stick = {v[kStick], v[kStick + 1], v[kStick + 2]};
  row.pedal_left = v[kPedals];
  row.pedal_right = v[kPedals + 1];
  return row;
}

/// A column with a number other than 0 was measured; one measured arm joint means that all were.
DofMask measuredBy(const Numbers& v) {
  DofMask measured = 0;
  for (std::size_t i = 0; i < 6; ++i) measured |= mask(dofAt(i));
  for (std::size_t i = kArm; i < kColumns; ++i) {
    if (v[i] == 0.0) continue;
    if (i >= kGrip) measured |= mask(dofAt(index(Dof::Grip) + i - kGrip));
    if (i < kGrip) {
      for (std::size_t j = 0; j < kArmJointCount; ++j)
        measured |= mask(dofAt(index(Dof::ShoulderFlexion) + j));
    }
  }
  return measured;
}

}  // namespace

Recording parseRecording(std::istream& in, const std::string& name) {
  Recording recording;
  recording.name = name;
  Place place{name, 0};
  std::string line;
  if (!nextLine(in, line, place.line))
    Place{name, 1}.fail(1, "the file is empty; its first line must be " + kRecordingHeader);
  checkHeader(line, place);
  double first_time = 0.0;
  while (nextLine(in, line, place.line)) {
    const Numbers v = readNumbers(line, place);
    if (recording.rows.empty()) first_time = v[kTime];
    const RecordedRow row = toRow(v, first_time);
    if (!recording.rows.empty() && row.time_ns <= recording.rows.back().time_ns) {
      place.fail(1, "t_s is " + number(v[kTime]) + ", must be later than the row before");
    }
    recording.rows.push_back(row);
    recording.measured |= measuredBy(v);
  }
  if (in.bad()) place.fail(1, "reading failed: " + std::string(std::strerror(errno)));
  if (recording.rows.empty()) place.fail(1, "there are no rows after the header; one at least is needed");
  return recording;
}

Recording readRecording(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path + ": cannot be opened: " + std::strerror(errno));
  if (std::filesystem::is_directory(path))
    throw std::runtime_error(path + ": is a folder; name a CSV file in it");
  return parseRecording(in, path);
}

}  // namespace coherency
