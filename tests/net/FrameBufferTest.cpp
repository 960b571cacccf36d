#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "render_client/receive/FrameBuffer.h"
#include "tests/net/Support.h"

namespace coherency {
namespace {

constexpr std::int64_t kFrameNs = 10'000'000;

/// Seen at its number's moment.
ReceivedFrame frame(std::uint64_t number) {
  return {1,
          testing::frameOf(number, number, static_cast<std::int64_t>(number % 1'000'000'000) * kFrameNs, {}),
          {static_cast<std::int64_t>(number % 1000)},
          {0}};
}
ServerTime moment(std::int64_t number) {
  return {number * kFrameNs};
}

constexpr std::int64_t kSlowDraw = 1'000 * kFrameNs;  // no time for two pictures where there is for one

std::uint64_t numberOf(const std::optional<ReceivedFrame>& frame) {
  return frame ? frame->state.number : 0;
}
std::vector<std::uint64_t> numbersOf(const std::vector<ReceivedFrame>& frames) {
  std::vector<std::uint64_t> numbers;
  for (const ReceivedFrame& f : frames) numbers.push_back(f.state.number);
  return numbers;
}
using Numbers = std::vector<std::uint64_t>;

class FrameBufferTest : public ::testing::Test {
 protected:
  void add(std::initializer_list<std::uint64_t> numbers) {
    for (const std::uint64_t n : numbers) EXPECT_TRUE(buffer_.add(frame(n))) << n;
  }
  std::uint64_t next(std::uint64_t after, std::uint64_t stride, std::int64_t earliest) const {
    return numberOf(buffer_.next(after, stride, moment(earliest), kSlowDraw));
  }
  FrameBuffer buffer_;
};

TEST_F(FrameBufferTest, OfNothingThereIsNothing) {
  EXPECT_EQ(buffer_.newest(), 0U);
  EXPECT_EQ(next(0, 1, 0), 0U);
  EXPECT_TRUE(buffer_.between(0, 100, 1).empty());
}

TEST_F(FrameBufferTest, EachIsTakenOnceAndAsItCameFirst) {
  add({7});
  ReceivedFrame again = frame(7);
  again.arrived = {999};
  EXPECT_FALSE(buffer_.add(again));
  EXPECT_EQ(buffer_.next(0, 1, {0}, kSlowDraw)->arrived, frame(7).arrived);
}

TEST_F(FrameBufferTest, TheFirstThatCanBeSeenInItsTime) {
  add({10, 11, 12, 13});
  EXPECT_EQ(next(9, 1, 0), 10U);
  EXPECT_EQ(next(9, 1, 10), 10U) << "its photons are not before: it can";
  EXPECT_EQ(next(9, 1, 11), 11U);
  EXPECT_EQ(next(11, 1, 0), 12U) << "what was drawn is not drawn again";
  EXPECT_EQ(next(13, 1, 0), 0U);
}

TEST_F(FrameBufferTest, WhereNoneCanTheNewestIsDrawnLate) {
  add({10, 11, 12});
  EXPECT_EQ(next(9, 1, 100), 12U);
  EXPECT_EQ(next(12, 1, 100), 0U);
}

TEST_F(FrameBufferTest, OneThatIsALittleLateIsDrawnWhereTheNextStillComesInTime) {
  add({10, 11});
  const auto next = [this](std::int64_t draw_ns) {
    return numberOf(buffer_.next(9, 1, moment(10) + kFrameNs / 4, draw_ns));
  };
  EXPECT_EQ(next(kFrameNs / 2), 10U);
  EXPECT_EQ(next(kFrameNs), 11U);
}

TEST_F(FrameBufferTest, OfAsManyAsTheStrideTheFirstThatIsHere) {
  add({10, 11, 13, 14, 15, 16});
  EXPECT_EQ(next(0, 4, 0), 10U) << "of 8 to 11";
  EXPECT_EQ(next(10, 4, 0), 13U) << "of 12 to 15";
  EXPECT_EQ(next(13, 4, 0), 16U);
  EXPECT_EQ(next(11, 4, 14), 16U) << "13 is too late, and nobody draws 14 in its place";
  EXPECT_EQ(next(0, 4, 100), 16U);
  EXPECT_EQ(next(0, 7, 0), 10U);
  EXPECT_EQ(next(0, 20, 0), 0U);
}

TEST_F(FrameBufferTest, GapsAreStrodeOver) {
  add({3, 9, 5});  // in whatever order
  EXPECT_EQ(next(0, 1, 0), 3U);
  EXPECT_EQ(next(3, 1, 0), 5U);
  EXPECT_EQ(next(5, 1, 6), 9U);
}

TEST_F(FrameBufferTest, BetweenLeavesOutBothEnds) {
  add({10, 11, 13, 14});
  EXPECT_EQ(numbersOf(buffer_.between(10, 14, 1)), (Numbers{11, 13}));
  EXPECT_EQ(numbersOf(buffer_.between(9, 15, 2)), (Numbers{10, 13}));
  EXPECT_TRUE(buffer_.between(10, 11, 1).empty());
  EXPECT_TRUE(buffer_.between(14, 10, 1).empty());
}

TEST_F(FrameBufferTest, OnlyTheNewestNumbersAreRemembered) {
  const std::uint64_t last = 3 * FrameBuffer::kRemembered + 8;
  for (std::uint64_t n = 1; n <= last; ++n) add({n});
  EXPECT_FALSE(buffer_.add(frame(FrameBuffer::kRemembered)));
  EXPECT_EQ(next(0, 1, 0), last - FrameBuffer::kRemembered + 1);
  EXPECT_EQ(buffer_.between(0, last + 1, 1).size(), FrameBuffer::kRemembered);
  EXPECT_EQ(buffer_.newest(), last);
}

TEST_F(FrameBufferTest, WhatIsTooOldIsRefusedWhereItsPlaceIsEmptyToo) {
  add({1000});
  EXPECT_FALSE(buffer_.add(frame(1000 - FrameBuffer::kRemembered)));
  EXPECT_FALSE(buffer_.add(frame(1001 - FrameBuffer::kRemembered - 2)));
  EXPECT_TRUE(buffer_.add(frame(1001 - FrameBuffer::kRemembered)));
}

TEST_F(FrameBufferTest, TheFirstFromANumberOnIsKeptUntilAskedForHoweverLate) {
  buffer_.keepFirstFrom({7, 9, 1'000'000});
  const auto kept = [&](std::uint64_t number) { return numberOf(buffer_.firstFrom(number)); };
  add({8, 7, 12});
  EXPECT_EQ(kept(7), 7U);
  EXPECT_EQ(kept(9), 12U);
  add({10});  // or it only came in another order
  EXPECT_EQ(kept(9), 10U);
  for (std::uint64_t n = 13; n <= 5 * FrameBuffer::kRemembered; ++n) add({n});
  EXPECT_EQ(kept(7), 7U);
  EXPECT_EQ(kept(9), 10U);
  EXPECT_EQ(kept(1'000'000), 0U);
  EXPECT_EQ(kept(8), 0U) << "was not to be kept";
  buffer_.keepFirstFrom({9});
  EXPECT_EQ(kept(7), 0U);
  EXPECT_EQ(kept(9), 10U);
  buffer_.clear();
  EXPECT_EQ(kept(9), 0U);
  EXPECT_EQ(buffer_.newest(), 0U);
}

// A hostile server may number as it likes; what it says must not make a client spin.
TEST_F(FrameBufferTest, NumbersAtTheEndOfAllNumbersAreRefused) {
  EXPECT_FALSE(buffer_.add(frame(~std::uint64_t{0})));
  EXPECT_FALSE(buffer_.add(frame(FrameBuffer::kMostNumber + 1)));
  EXPECT_EQ(next(0, 1, 0), 0U);
  add({FrameBuffer::kMostNumber});
  EXPECT_EQ(next(0, 1, 0), FrameBuffer::kMostNumber);
  EXPECT_EQ(next(FrameBuffer::kMostNumber, 1'000, 0), 0U);
}

/// Remembers everything and looks through all of it.
struct Naive {
  std::map<std::uint64_t, ReceivedFrame> frames;
  std::uint64_t newest() const { return frames.empty() ? 0 : frames.rbegin()->first; }
  bool tooOld(std::uint64_t number) const { return number + FrameBuffer::kRemembered <= newest(); }
  bool add(const ReceivedFrame& f) {
    if (tooOld(f.state.number)) return false;
    return frames.emplace(f.state.number, f).second;
  }
  std::uint64_t next(std::uint64_t after, std::uint64_t stride, ServerTime earliest) const {
    std::uint64_t late = 0;
    for (const std::uint64_t n : between(after, ~std::uint64_t{0}, stride)) {
      if (frames.at(n).state.photons() >= earliest) return n;
      late = n;
    }
    return late;
  }
  Numbers between(std::uint64_t after, std::uint64_t before, std::uint64_t stride) const {
    const std::uint64_t forgotten =
        newest() > FrameBuffer::kRemembered ? newest() - FrameBuffer::kRemembered : 0;
    std::uint64_t group = std::max(after, forgotten) / stride;
    Numbers numbers;
    for (const auto& [n, f] : frames) {
      if (n / stride <= group || n / stride >= before / stride) continue;
      group = n / stride;
      numbers.push_back(n);
    }
    return numbers;
  }
};

RC_GTEST_PROP(FrameBuffer, AgreesWithOneThatLooksThroughEverything, ()) {
  FrameBuffer buffer;
  Naive naive;
  std::uint64_t newest = *rc::gen::inRange<std::uint64_t>(1, 300);
  const int steps = *rc::gen::inRange(1, 120);
  for (int i = 0; i < steps; ++i) {
    newest += *rc::gen::inRange<std::uint64_t>(0, 12);
    const auto back = *rc::gen::weightedOneOf<std::uint64_t>({{5, rc::gen::just<std::uint64_t>(0)},
                                                              {3, rc::gen::inRange<std::uint64_t>(0, 10)},
                                                              {2, rc::gen::inRange<std::uint64_t>(0, 200)}});
    const std::uint64_t number = newest > back ? newest - back : 1;
    const bool same = buffer.add(frame(number)) == naive.add(frame(number));
    RC_ASSERT(same);
    RC_ASSERT(buffer.newest() == naive.newest());
    const auto after = *rc::gen::inRange<std::uint64_t>(0, newest + 20);
    const auto stride = *rc::gen::inRange<std::uint64_t>(1, 9);
    const auto earliest = moment(static_cast<std::int64_t>(*rc::gen::inRange<std::uint64_t>(0, newest + 20)));
    RC_ASSERT(numberOf(buffer.next(after, stride, earliest, kSlowDraw)) ==
              naive.next(after, stride, earliest));
    RC_ASSERT(numbersOf(buffer.between(after, newest + 5, stride)) ==
              naive.between(after, newest + 5, stride));
  }
}

}  // namespace
}  // namespace coherency
