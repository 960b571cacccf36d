#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion_server/broadcast/StereoAgreement.h"

namespace coherency {
namespace {

FrameReport drawn(std::uint64_t number, std::uint64_t hash = 0xaa, std::int64_t presented_ns = 0,
                  std::uint64_t tick = 7) {
  return {number, Fate::Drawn, tick, hash, presented_ns, 1, 1};
}
FrameReport left_out(std::uint64_t number, Fate fate) {
  return {.number = number, .fate = fate};
}

TEST(StereoAgreement, OfNothingItIsWhole) {
  EXPECT_EQ(StereoAgreement().status().agreement(), 1.0);
}

TEST(StereoAgreement, PairsTheSameFrameWhicheverComesFirst) {
  StereoAgreement stereo;
  stereo.add("left", drawn(10, 0xaa, 1000));
  EXPECT_EQ(stereo.status().frames_compared, 0U);
  stereo.add("right", drawn(10, 0xaa, 1300));
  stereo.add("right", drawn(11, 0xbb, 2000));
  stereo.add("left", drawn(11, 0xbb, 2500));
  EXPECT_EQ(stereo.status().frames_compared, 2U);
  EXPECT_EQ(stereo.status().frames_agreeing, 2U);
  EXPECT_EQ(stereo.status().present_skew_ns, (std::vector<std::int64_t>{300, -500}));  // right after left
  EXPECT_EQ(stereo.status().agreement(), 1.0);
}

TEST(StereoAgreement, TellsAnotherMomentFromAnotherStateOfOneMoment) {
  StereoAgreement stereo;
  stereo.add("left", drawn(10, 0xaa, 0, 7));
  stereo.add("right", drawn(10, 0xaa, 0, 8));
  stereo.add("left", drawn(11, 0xaa, 0, 9));
  stereo.add("right", drawn(11, 0xab, 0, 9));
  EXPECT_EQ(stereo.status().frames_compared, 2U);
  EXPECT_EQ(stereo.status().frames_agreeing, 0U);
  EXPECT_EQ(stereo.status().other_tick, 1U);
  EXPECT_EQ(stereo.status().other_state, 1U);
  EXPECT_EQ(stereo.status().agreement(), 0.0);
}

TEST(StereoAgreement, AFrameThatOneEyeLeftOutIsCountedByItsCauseWhoeverSaysSoFirst) {
  for (const bool drawn_first : {true, false}) {
    StereoAgreement stereo;
    std::uint64_t number = 1;
    for (const Fate fate : {Fate::InputLate, Fate::DrawingLate, Fate::DrawingLate, Fate::Mismatch}) {
      if (drawn_first) stereo.add("left", drawn(number));
      stereo.add("right", left_out(number, fate));
      if (!drawn_first) stereo.add("left", drawn(number));
      ++number;
    }
    EXPECT_EQ(stereo.status().input_late, 1U);
    EXPECT_EQ(stereo.status().drawing_late, 2U);
    EXPECT_EQ(stereo.status().mismatch, 1U);
    EXPECT_EQ(stereo.status().lost, 0U);
    EXPECT_EQ(stereo.status().oneEyed(), 4U);
    EXPECT_EQ(stereo.status().frames_compared, 0U);
  }
}

TEST(StereoAgreement, WhatNeitherEyeDrewWasNotSeen) {
  StereoAgreement stereo;
  stereo.add("left", left_out(10, Fate::InputLate));
  stereo.add("right", left_out(10, Fate::DrawingLate));
  EXPECT_EQ(stereo.status().oneEyed(), 0U);
  EXPECT_EQ(stereo.status().agreement(), 1.0);
}

TEST(StereoAgreement, AFrameThatAnEyeNeverSpeaksOfWasLostThere) {
  StereoAgreement stereo;
  for (const auto* eye : {"left", "right"}) stereo.add(eye, drawn(10));
  stereo.add("left", drawn(11));
  stereo.add("left", drawn(12));
  EXPECT_EQ(stereo.status().lost, 0U) << "the other eye may still speak of it";
  stereo.add("right", drawn(12));
  EXPECT_EQ(stereo.status().lost, 1U);
  stereo.add("right", drawn(14));  // passes 13 over, which the left then says
  stereo.add("left", drawn(13));
  EXPECT_EQ(stereo.status().lost, 2U);
  stereo.add("left", drawn(14));
  EXPECT_EQ(stereo.status().frames_agreeing, 3U);
  EXPECT_DOUBLE_EQ(stereo.status().agreement(), 3.0 / 5.0);
}

TEST(StereoAgreement, FramesBeforeAnEyeCameAreNotMissed) {
  StereoAgreement stereo;
  for (std::uint64_t n = 1; n <= 100; ++n) stereo.add("left", drawn(n));
  for (std::uint64_t n = 50; n <= 100; ++n) stereo.add("right", drawn(n));
  EXPECT_EQ(stereo.status().lost, 0U);
  EXPECT_EQ(stereo.status().frames_agreeing, 51U);
}

TEST(StereoAgreement, AnEyeThatStartsAgainIsNotMissedWhileItIsGone) {
  StereoAgreement stereo;
  for (std::uint64_t n = 1; n <= 20; ++n)
    for (const auto* eye : {"left", "right"}) stereo.add(eye, drawn(n));
  stereo.left("right");
  for (std::uint64_t n = 21; n <= 60; ++n) stereo.add("left", drawn(n));
  for (std::uint64_t n = 61; n <= 80; ++n)
    for (const auto* eye : {"left", "right"}) stereo.add(eye, drawn(n));
  EXPECT_EQ(stereo.status().lost, 0U);
  EXPECT_EQ(stereo.status().frames_agreeing, 40U);
  stereo.left("mono");  // has no place here
  stereo.add("left", drawn(81));
  stereo.add("right", drawn(82));
  EXPECT_EQ(stereo.status().lost, 1U);
}

TEST(StereoAgreement, ANumberFarAheadSpoilsNothingOnceItsEyeHasGone) {
  StereoAgreement stereo;
  stereo.add("left", drawn(~std::uint64_t{0}));
  stereo.left("left");
  for (std::uint64_t n = 1; n <= 20; ++n)
    for (const auto* eye : {"left", "right"}) stereo.add(eye, drawn(n));
  EXPECT_EQ(stereo.status().frames_agreeing, 20U);
  EXPECT_EQ(stereo.status().lost, 0U);
}

TEST(StereoAgreement, OtherEyesAreNoPartners) {
  StereoAgreement stereo;
  stereo.add("left", drawn(10));
  stereo.add("both", drawn(10));
  stereo.add("mono", drawn(10));
  stereo.add("", drawn(10));
  EXPECT_EQ(stereo.status().frames_compared, 0U);
  EXPECT_EQ(stereo.status().oneEyed(), 0U);
}

TEST(StereoAgreement, ANumberThatDoesNotRiseIsPassedOver) {
  StereoAgreement stereo;
  stereo.add("left", drawn(10));
  stereo.add("right", drawn(10));
  stereo.add("left", drawn(10, 0xaa, 16));
  stereo.add("right", drawn(10, 0xff, 16));
  stereo.add("right", drawn(9, 0xff, 16));
  EXPECT_EQ(stereo.status().frames_compared, 1U);
  EXPECT_EQ(stereo.status().frames_agreeing, 1U);
}

TEST(StereoAgreement, MemoryIsBoundedAndReportsMayComeMuchLater) {
  StereoAgreement stereo;
  for (std::uint64_t n = 1; n <= 20'000; ++n) stereo.add("left", drawn(n, n));
  for (std::uint64_t n = 1; n <= 20'000; ++n) stereo.add("right", drawn(n, n, static_cast<std::int64_t>(n)));
  EXPECT_EQ(stereo.status().frames_compared, 4096U);  // the newest
  EXPECT_EQ(stereo.status().frames_agreeing, 4096U);
  for (std::uint64_t n = 20'001; n <= 40'000; ++n) {
    stereo.add("left", drawn(n, n));
    stereo.add("right", drawn(n, n, static_cast<std::int64_t>(n)));
  }
  EXPECT_EQ(stereo.status().frames_compared, 24'096U);
  EXPECT_EQ(stereo.status().present_skew_ns.size(), 4096U);
  EXPECT_EQ(stereo.status().lost, 0U);
}

/// What one eye says, by number.
using Said = std::map<std::uint64_t, FrameReport>;

Said arbitraryReports(std::uint64_t last) {
  Said said;
  for (std::uint64_t n = 1; n <= last; ++n) {
    if (n != 1 && n != last && *rc::gen::inRange(0, 4) == 0) continue;  // nothing of it came
    const Fate fate =
        n == 1 || n == last
            ? Fate::Drawn
            : *rc::gen::weightedElement<Fate>(
                  {{6, Fate::Drawn}, {1, Fate::InputLate}, {1, Fate::DrawingLate}, {1, Fate::Mismatch}});
    said[n] = {n, fate, *rc::gen::inRange<std::uint64_t>(0, 2), *rc::gen::inRange<std::uint64_t>(0, 2), 0,
               0, 0};
  }
  return said;
}

StereoStatus countedWithBothInHand(const Said& left, const Said& right) {
  StereoStatus status;
  const auto oneEye = [&](const FrameReport& own, const Said& other) {
    if (own.fate != Fate::Drawn) return;
    const auto theirs = other.find(own.number);
    if (theirs == other.end()) return void(++status.lost);
    if (theirs->second.fate == Fate::InputLate) ++status.input_late;
    if (theirs->second.fate == Fate::DrawingLate) ++status.drawing_late;
    if (theirs->second.fate == Fate::Mismatch) ++status.mismatch;
  };
  for (const auto& [n, r] : right) oneEye(r, left);
  for (const auto& [n, l] : left) {
    oneEye(l, right);
    const auto r = right.find(n);
    if (r == right.end() || l.fate != Fate::Drawn || r->second.fate != Fate::Drawn) continue;
    ++status.frames_compared;
    if (l.tick != r->second.tick)
      ++status.other_tick;
    else
      ++(l.hash == r->second.hash ? status.frames_agreeing : status.other_state);
  }
  return status;
}

// However the two eyes' reports come in among each other, the account is the one that has both in hand.
RC_GTEST_PROP(StereoAgreement, DoesNotDependOnTheOrderOfTheEyes, ()) {
  const auto last = *rc::gen::inRange<std::uint64_t>(2, 60);
  const Said left = arbitraryReports(last), right = arbitraryReports(last);
  StereoAgreement stereo;
  // Each eye's first comes at once: what is said before both are there counts for nobody.
  auto l = left.begin(), r = right.begin();
  stereo.add("left", (l++)->second);
  stereo.add("right", (r++)->second);
  while (l != left.end() || r != right.end()) {
    const bool left_next = r == right.end() || (l != left.end() && *rc::gen::arbitrary<bool>());
    left_next ? stereo.add("left", (l++)->second) : stereo.add("right", (r++)->second);
  }
  const StereoStatus expected = countedWithBothInHand(left, right);
  const StereoStatus& got = stereo.status();
  RC_ASSERT(got.frames_compared == expected.frames_compared);
  RC_ASSERT(got.frames_agreeing == expected.frames_agreeing);
  RC_ASSERT(got.other_tick == expected.other_tick);
  RC_ASSERT(got.other_state == expected.other_state);
  RC_ASSERT(got.input_late == expected.input_late);
  RC_ASSERT(got.drawing_late == expected.drawing_late);
  RC_ASSERT(got.mismatch == expected.mismatch);
  RC_ASSERT(got.lost == expected.lost);
}

}  // namespace
}  // namespace coherency
