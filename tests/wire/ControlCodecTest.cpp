#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/Validity.h"
#include "tests/wire/GoldenMessages.h"
#include "tests/wire/MessageGenerators.h"
#include "tests/wire/Protobuf.h"

namespace coherency {
namespace {

using Bytes = std::vector<std::byte>;
using protobuf::field;

Bytes encoded(const ControlMessage& message) {
  Bytes bytes;
  encodeControl(message, bytes);
  return bytes;
}
template <class T>
T decoded(std::span<const std::byte> bytes) {
  return std::get<T>(std::get<ControlMessage>(decodeControl(bytes)));
}
DecodedControl decodedText(const std::string& message) {
  return decodeControl(protobuf::bytes(message));
}
bool isRejected(const DecodedControl& decoded) {
  return std::holds_alternative<Reject>(decoded);
}

/// No, or something that can be true; a Hello of another major version is heard whatever else it says.
bool isRejectedOrValid(const DecodedControl& decoded) {
  if (isRejected(decoded)) return true;
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Hello>) {
          if (value.major != kWireMajor) return value == Hello{value.major, value.minor, {}, false};
        }
        return isValid(value);
      },
      std::get<ControlMessage>(decoded));
}

RC_GTEST_PROP(ControlCodec, EverythingComesBackAsItWas, ()) {
  for (const ControlMessage& message : arbitrary::oneOfEach())
    RC_ASSERT(arbitrary::same(std::get<ControlMessage>(decodeControl(encoded(message))), message));
}

RC_GTEST_PROP(ControlCodec, AMessageIsAppended, ()) {
  const ControlMessage message = arbitrary::goodbye();
  Bytes bytes(3, std::byte{9});
  encodeControl(message, bytes);
  const Bytes alone = encoded(message);
  RC_ASSERT(Bytes(bytes.begin() + 3, bytes.end()) == alone);
}

TEST(ControlCodec, TheLargestReportFitsAMessage) {
  ClientReport report;
  report.packets_received = report.packets_lost = ~std::uint64_t{0};
  report.frames.assign(kMaxReportFrames, {~std::uint64_t{0}, Fate::Mismatch, ~std::uint64_t{0},
                                          ~std::uint64_t{0}, kMaxTimeNs, kMaxTimeNs, kMaxTimeNs});
  EXPECT_LE(encoded(report).size() + 1 + kSealTag, kMaxControlMessage);
  EXPECT_EQ(decoded<ClientReport>(encoded(report)), report);
}

RC_GTEST_PROP(ControlCodec, DamageNeverYieldsWhatCannotBe, ()) {
  for (const ControlMessage& message : arbitrary::oneOfEach()) {
    const Bytes good = encoded(message);
    for (std::size_t i = 0; i < good.size(); ++i) {
      if (good.size() > 500 && *rc::gen::inRange(0, 8) != 0) continue;
      RC_ASSERT(isRejectedOrValid(decodeControl(std::span(good).first(i))));
      Bytes bad = good;
      bad[i] ^= static_cast<std::byte>(*rc::gen::inRange(1, 256));
      RC_ASSERT(isRejectedOrValid(decodeControl(bad)));
    }
  }
}

RC_GTEST_PROP(ControlCodec, RandomBytesNeverYieldWhatCannotBe, (const std::vector<std::uint8_t>& noise)) {
  RC_ASSERT(isRejectedOrValid(decodeControl(std::as_bytes(std::span(noise)))));
}

TEST(ControlCodec, EmptyAndTooLongAreRefused) {
  EXPECT_EQ(std::get<Reject>(decodeControl({})), Reject::Malformed);
  EXPECT_EQ(std::get<Reject>(decodeControl(Bytes(kMaxControlMessage + 1))), Reject::Oversized);
}

TEST(ControlCodec, OfAnotherMajorVersionNothingButTheNumberCounts) {
  const auto hello =
      decodedText(field(1, field(1, std::uint64_t{4}) + field(2, std::uint64_t{7}) + field(3, "\x01") +
                               field(5, "no key") + field(6, std::uint64_t{1})));
  EXPECT_EQ(std::get<Hello>(std::get<ControlMessage>(hello)), (Hello{4, 7, {}, false}));
}

TEST(ControlCodec, AHelloOfOursHasAWholeKey) {
  const auto hello = [](std::size_t size) {
    return decodedText(field(1, field(1, std::uint64_t{kWireMajor}) + field(5, std::string(size, 'k'))));
  };
  EXPECT_FALSE(isRejected(hello(32)));
  for (const std::size_t size : {0U, 31U, 33U}) EXPECT_TRUE(isRejected(hello(size))) << size;
}

RC_GTEST_PROP(ControlCodec, UnknownFieldsOfANewerMinorAreIgnored, ()) {
  for (const ControlMessage& message : arbitrary::oneOfEach()) {
    if (std::holds_alternative<Tunnelled>(message)) continue;  // bytes, not a message
    const Bytes extended = protobuf::withUnknownFields(encoded(message));
    if (extended.size() > kMaxControlMessage) continue;
    RC_ASSERT(arbitrary::same(std::get<ControlMessage>(decodeControl(extended)), message));
  }
}

TEST(ControlCodec, ACauseOfANewerMinorStillEndsTheConnection) {
  const auto goodbye = decodedText(field(4, field(1, "new") + field(2, std::uint64_t{99})));
  EXPECT_EQ(std::get<Goodbye>(std::get<ControlMessage>(goodbye)), (Goodbye{"new", GoodbyeCause::Leaving}));
}

TEST(ControlCodec, WhatThereIsNotIsRefused) {
  EXPECT_FALSE(isRejected(decodedText(field(5, field(1, std::uint64_t{1})))));
  EXPECT_TRUE(isRejected(decodedText(field(5, field(1, std::uint64_t{2}))))) << "a third mode";
  EXPECT_TRUE(isRejected(decodedText(field(6, field(1, "third"))))) << "a third eye";
  EXPECT_TRUE(isRejected(decodedText(field(9, "")))) << "a datagram of nothing";
  const auto frame = [](const std::string& fields) { return field(3, field(1, fields)); };
  EXPECT_FALSE(isRejected(decodedText(frame(field(2, std::uint64_t{3})))));
  EXPECT_TRUE(isRejected(decodedText(frame(field(2, std::uint64_t{4}))))) << "a fate of a newer version";
  EXPECT_TRUE(isRejected(decodedText(frame(field(7, ~std::uint64_t{0}))))) << "500 years of drawing";
}

TEST(ControlCodec, AKeyframeIsOfAsManyAsItSays) {
  const std::string movable = field(7, field(6, std::string(12, '\0') + std::string("\0\0\0\x40", 4)));
  const auto keyframe = [](std::uint64_t number, std::uint64_t movables, std::uint64_t doors,
                           const std::string& world) {
    return decodedText(field(7, field(1, number) + field(2, movables) + field(3, doors) + world));
  };
  const std::string nothing = field(4, "");
  EXPECT_FALSE(isRejected(keyframe(1, 0, kMaxDoors, nothing)));
  EXPECT_FALSE(isRejected(keyframe(1, 1, 0, field(4, movable))));
  EXPECT_TRUE(isRejected(keyframe(0, 0, 0, nothing)));
  EXPECT_TRUE(isRejected(keyframe(1, 0, 0, ""))) << "no world";
  EXPECT_TRUE(isRejected(keyframe(1, 0, 0, field(4, movable)))) << "one too many";
  EXPECT_TRUE(isRejected(keyframe(1, 1, 0, nothing))) << "its attitude is no rotation";
  EXPECT_TRUE(isRejected(keyframe(1, kMaxMovables + 1, 0, nothing)));
  EXPECT_TRUE(isRejected(keyframe(1, 0, kMaxDoors + 1, nothing)));
}

/// The golden Welcome as text, to take apart.
std::string welcome() {
  const Bytes bytes = encoded(golden::session());
  return sealing::textOf(bytes).substr(3);
}
DecodedControl welcomeOf(const std::string& fields) {
  return decodedText(field(2, fields));
}

TEST(ControlCodec, AWelcomeWithAMeasureMissingOrTwiceIsRefused) {
  const RigField& first = rigFields().front();
  const double value = golden::rig().*(first.value);
  const std::string number(reinterpret_cast<const char*>(&value), sizeof value);  // little-endian, as here
  const std::string measure =
      field(5, field(1, std::string(first.name)) + protobuf::varint(2 << 3 | 1) + number);
  const std::size_t at = welcome().find(measure);
  ASSERT_NE(at, std::string::npos);
  EXPECT_FALSE(isRejected(welcomeOf(welcome())));
  EXPECT_TRUE(isRejected(welcomeOf(welcome().erase(at, measure.size()))));
  EXPECT_TRUE(isRejected(welcomeOf(welcome() + measure)));
  const std::string newer = field(5, field(1, "nose_length") + protobuf::varint(2 << 3 | 1) + number);
  EXPECT_FALSE(isRejected(welcomeOf(welcome() + newer))) << "a measure of a newer minor version";
}

TEST(ControlCodec, AWelcomeSaysWhereEveryDofStands) {
  const std::string one_more = field(10, std::string(4, '\0'));
  EXPECT_TRUE(isRejected(welcomeOf(welcome() + one_more)));
}

TEST(ControlCodec, NumbersThatWouldBeCutAreRefused) {
  EXPECT_TRUE(isRejected(welcomeOf(welcome() + field(7, std::uint64_t{65536 + 7430}))));
  EXPECT_TRUE(isRejected(welcomeOf(welcome() + field(14, std::uint64_t{65536 + 7430}))));
  EXPECT_TRUE(isRejected(welcomeOf(welcome() + field(6, ~std::uint64_t{0}))));
  EXPECT_TRUE(isRejected(welcomeOf(welcome() + field(12, ~std::uint64_t{0}))));
}

}  // namespace
}  // namespace coherency
