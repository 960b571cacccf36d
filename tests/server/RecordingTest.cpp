#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion_server/device/Recording.h"
#include "motion_server/device/ReplayMaster.h"

namespace coherency {
namespace {

const std::string kRow0 = "0.0,0.1,1.6,-0.2,1,0,0,0,0.1,-0.4,0.5,1.2,0.3,0.2,0.1,0,0,0,0,0,0\n";
const std::string kRow1 = "0.01,0.2,1.7,-0.1,1,0,0,0,0.2,-0.3,0.6,1.3,0.4,0.3,0.2,0,0,0,0,0,0\n";

Recording parse(const std::string& text) {
  std::istringstream in(text);
  return parseRecording(in, "walk.csv");
}

std::string errorOf(const std::string& text) {
  try {
    parse(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

std::string withRows(const std::string& rows) {
  return kRecordingHeader + "\n" + rows;
}

void expectError(const std::string& text, const std::string& place, const std::string& says) {
  const std::string error = errorOf(text);
  EXPECT_EQ(error.rfind("walk.csv:" + place + ": ", 0), 0u) << error;
  EXPECT_NE(error.find(says), std::string::npos) << error;
}

TEST(Recording, ReadsRows) {
  const Recording r = parse(withRows(kRow0 + kRow1));
  ASSERT_EQ(r.rows.size(), 2u);
  EXPECT_EQ(r.rows[1].time_ns, 10'000'000);
  EXPECT_EQ(r.rows[1].head, Coord3(0.2, 1.7, -0.1));
  EXPECT_EQ(r.rows[0].arm[3], 1.2);
  EXPECT_EQ(r.durationNs(), 10'000'000);
}

TEST(Recording, TimesBeginAtTheFirstRow) {
  const Recording r = parse(withRows("7.5" + kRow0.substr(3) + "8.0" + kRow1.substr(4)));
  EXPECT_EQ(r.rows[0].time_ns, 0);
  EXPECT_EQ(r.rows[1].time_ns, 500'000'000);
}

TEST(Recording, AcceptsCarriageReturnsAndAnEmptyLastLine) {
  std::string text = withRows(kRow0 + kRow1) + "\n";
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += 2) text.insert(i, "\r");
  EXPECT_EQ(parse(text).rows.size(), 2u);
}

TEST(Recording, TellsWhichDofsWereMeasured) {
  const DofMask head = 0x3F;
  const DofMask arm = 0x7F << 6;
  EXPECT_EQ(parse(withRows(kRow0)).measured, head | arm);
  EXPECT_EQ(parse(withRows("0,0,1.6,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n")).measured, head);
  EXPECT_EQ(parse(withRows("0,0,1.6,0,1,0,0,0,0,0,0,0,0,0,0,0.5,0,-1,0,0,0.1\n")).measured,
            head | mask(Dof::Grip) | mask(Dof::StickY) | mask(Dof::PedalRight));
}

TEST(Recording, ErrorsNameThePlace) {
  expectError("", "1:1", "empty");
  expectError(kRecordingHeader + "\n", "1:1", "no rows");
  expectError("time,x\n", "1:1", "must be 't_s'");
  expectError("t_s,head_x_m\n", "1:13", "'head_y_m' is missing");
  expectError(kRecordingHeader + ",more\n" + kRow0, "1:" + std::to_string(kRecordingHeader.size() + 2),
              "22 columns");
  expectError(withRows("0.0,0.1,1.6\n"), "2:12", "3 columns, must be 21");
  expectError(withRows(kRow0 + "0.01,hello" + kRow0.substr(7)), "3:6", "head_x_m is 'hello'");
  expectError(withRows("0.0,nan" + kRow0.substr(7)), "2:5", "finite number");
  expectError(withRows("0.0,inf" + kRow0.substr(7)), "2:5", "finite number");
  expectError(withRows("0.0,1e999" + kRow0.substr(7)), "2:5", "finite number");
  expectError(withRows("0.0," + kRow0.substr(7)), "2:5", "finite number");
  expectError(withRows("0.0, 0.1" + kRow0.substr(7)), "2:5", "finite number");
  expectError(withRows(kRow0 + kRow0), "3:1", "later than the row before");
  expectError(withRows(kRow1 + kRow0), "3:1", "later than the row before");
  expectError(withRows("0.0,0.1,1.6,-0.2,1.01" + kRow0.substr(18)), "2:18", "length 1.01");
  expectError(withRows("0.0,0.1,1.6,-0.2,0" + kRow0.substr(18)), "2:18", "length 0");
  expectError(withRows("0.0,50" + kRow0.substr(7)), "2:5", "-10 to 10 m");
  expectError(withRows("1e300" + kRow0.substr(3)), "2:1", "t_s");
}

TEST(Recording, HeadAndHandFilesAreRefusedWithTheRemedy) {
  const std::string header =
      "t_s,head_x_m,head_y_m,head_z_m,head_qw,head_qx,head_qy,head_qz,hand_x_m,hand_y_m,hand_z_m,hand_qw,"
      "hand_qx,"
      "hand_qy,hand_qz\n";
  expectError(header + "0,0,1,0,1,0,0,0,0,0,0,1,0,0,0\n", "1:1", "without '_headhand'");
}

TEST(Recording, AMissingFileIsNamed) {
  try {
    readRecording("no/such/file.csv");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no/such/file.csv"), std::string::npos) << error.what();
  }
}

RC_GTEST_PROP(Recording, ArbitraryTextIsRefusedWithAPlaceOrRead, ()) {
  const auto junk =
      *rc::gen::container<std::string>(rc::gen::element('0', '1', '.', ',', '-', 'e', '\n', 'x', '\0'));
  const std::string error = errorOf(withRows(kRow0 + junk));
  RC_ASSERT(error == "accepted" || error.rfind("walk.csv:", 0) == 0);
}

TEST(Recording, EveryRecordingFitsTheDofTable) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(COHERENCY_MOTION_DATA)) GTEST_SKIP() << "no recordings at " COHERENCY_MOTION_DATA;
  int read = 0;
  for (const auto& entry : fs::directory_iterator(COHERENCY_MOTION_DATA)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".csv") continue;
    if (name.find("_headhand") != std::string::npos) {
      EXPECT_THROW(readRecording(entry.path().string()), std::runtime_error);
      continue;
    }
    const Recording r = readRecording(entry.path().string());
    EXPECT_GT(r.rows.size(), 1000u) << name;
    EXPECT_EQ((r.measured & mask(Dof::ElbowFlexion)) != 0, name.rfind("cmu_", 0) == 0) << name;
    EXPECT_EQ(r.measured & ~DofMask{0x1FFF}, 0u) << name << " has no controls";
    ++read;
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace coherency
