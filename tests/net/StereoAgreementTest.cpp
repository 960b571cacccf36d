#include <gtest/gtest.h>

#include "motion_server/broadcast/StereoAgreement.h"

namespace coherency {
namespace {

TEST(StereoAgreement, PairsTheSameSampleWhicheverComesFirst) {
  StereoAgreement stereo;
  stereo.add("left", {10, 0xaa, 1000});
  EXPECT_EQ(stereo.status().frames_compared, 0U);
  stereo.add("right", {10, 0xaa, 1300});
  stereo.add("right", {20, 0xbb, 2000});
  stereo.add("left", {20, 0xbb, 2500});
  EXPECT_EQ(stereo.status().frames_compared, 2U);
  EXPECT_EQ(stereo.status().frames_agreeing, 2U);
  EXPECT_EQ(stereo.status().present_skew_ns, (std::vector<std::int64_t>{300, -500}));  // right after left
}

TEST(StereoAgreement, AnotherHashDisagrees) {
  StereoAgreement stereo;
  stereo.add("left", {10, 0xaa, 0});
  stereo.add("right", {10, 0xab, 0});
  EXPECT_EQ(stereo.status().frames_compared, 1U);
  EXPECT_EQ(stereo.status().frames_agreeing, 0U);
}

TEST(StereoAgreement, OtherSamplesAndOtherEyesAreNoPartners) {
  StereoAgreement stereo;
  stereo.add("left", {10, 0xaa, 0});
  stereo.add("left", {11, 0xaa, 0});
  stereo.add("right", {12, 0xaa, 0});
  stereo.add("both", {10, 0xaa, 0});
  stereo.add("mono", {11, 0xaa, 0});
  EXPECT_EQ(stereo.status().frames_compared, 0U);
}

TEST(StereoAgreement, AFrameDrawnTwiceCountsOnce) {
  StereoAgreement stereo;
  stereo.add("left", {10, 0xaa, 0});
  stereo.add("right", {10, 0xaa, 0});
  stereo.add("left", {10, 0xaa, 16});
  stereo.add("right", {10, 0xff, 16});
  EXPECT_EQ(stereo.status().frames_compared, 1U);
  EXPECT_EQ(stereo.status().frames_agreeing, 1U);
}

TEST(StereoAgreement, MemoryIsBoundedAndReportsMayComeMuchLater) {
  StereoAgreement stereo;
  for (std::uint64_t s = 1; s <= 20'000; ++s) stereo.add("left", {s, s, 0});
  for (std::uint64_t s = 1; s <= 20'000; ++s) stereo.add("right", {s, s, static_cast<std::int64_t>(s)});
  EXPECT_EQ(stereo.status().frames_compared, 4096U);  // the newest
  EXPECT_EQ(stereo.status().frames_agreeing, 4096U);
  for (std::uint64_t s = 20'001; s <= 40'000; ++s) {
    stereo.add("left", {s, s, 0});
    stereo.add("right", {s, s, static_cast<std::int64_t>(s)});
  }
  EXPECT_EQ(stereo.status().frames_compared, 24'096U);
  EXPECT_EQ(stereo.status().present_skew_ns.size(), 4096U);
}

}  // namespace
}  // namespace coherency
