#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/Discovery.h"
#include "common/wire/Validity.h"
#include "tests/wire/GoldenMessages.h"
#include "tests/wire/MessageGenerators.h"
#include "tests/wire/Protobuf.h"

namespace coherency {
namespace {

using Bytes = std::vector<std::byte>;
using Decoded = std::variant<Reject, Search, Announcement>;

bool isRejectedOrValid(const Decoded& decoded) {
  const auto* const announcement = std::get_if<Announcement>(&decoded);
  return announcement == nullptr || isValid(*announcement);
}

Bytes datagramOf(const std::string& message) {
  return protobuf::bytes(std::string("COH\0", 4) + message);
}
std::string messageIn(const Bytes& datagram) {
  return sealing::textOf(datagram).substr(4);
}

RC_GTEST_PROP(Discovery, SearchesAndAnnouncementsOfAnyMajorComeBackAsTheyWere, ()) {
  const Search search{*rc::gen::arbitrary<std::uint32_t>()};
  const Announcement announcement = arbitrary::announcement();
  RC_ASSERT(std::get<Search>(decodeDiscovery(encodeDiscovery(search))) == search);
  RC_ASSERT(std::get<Announcement>(decodeDiscovery(encodeDiscovery(announcement))) == announcement);
}

TEST(Discovery, NoAnnouncementIsLongerThanASearch) {
  const std::string longest(kMaxText, 'a');
  const Announcement announcement{~0U, ~0U, longest, longest, 65535, true, ~0U};
  ASSERT_TRUE(isValid(announcement));
  EXPECT_LE(encodeDiscovery(announcement).size(), kSearchSize);
  EXPECT_GE(encodeDiscovery(Search{0}).size(), kSearchSize);
}

TEST(Discovery, AShortSearchHasNoAnswer) {
  const auto search = [](std::size_t size) {
    // 4 of the prefix, 3 of the message's header, 2 of the major, 3 of the padding's header.
    const std::string padding(size - 12, '\0');
    return datagramOf(
        protobuf::field(1, protobuf::field(1, std::uint64_t{kWireMajor}) + protobuf::field(2, padding)));
  };
  ASSERT_EQ(search(kSearchSize).size(), kSearchSize);
  EXPECT_EQ(std::get<Search>(decodeDiscovery(search(kSearchSize))), Search{});
  EXPECT_EQ(std::get<Reject>(decodeDiscovery(search(kSearchSize - 1))), Reject::Malformed);
  const Bytes whole = encodeDiscovery(Search{});
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(std::holds_alternative<Reject>(decodeDiscovery(std::span(whole).first(size)))) << size;
}

TEST(Discovery, AnAnnouncementSaysWhatCanBe) {
  const auto refused = [](const std::string& fields) {
    return std::holds_alternative<Reject>(decodeDiscovery(datagramOf(protobuf::field(2, fields))));
  };
  using protobuf::field;
  const std::string scene = field(4, "laboratory");
  EXPECT_FALSE(refused(scene + field(5, std::uint64_t{7430})));
  EXPECT_TRUE(refused(scene)) << "no port";
  EXPECT_TRUE(refused(scene + field(5, std::uint64_t{65536})));
  EXPECT_TRUE(refused(field(5, std::uint64_t{7430}))) << "no scene";
  EXPECT_TRUE(refused(field(4, "../etc") + field(5, std::uint64_t{7430})));
  EXPECT_TRUE(refused(field(3, "\x1b[2J") + scene + field(5, std::uint64_t{7430})));
  EXPECT_TRUE(refused(field(3, std::string(kMaxText + 1, 'h')) + scene + field(5, std::uint64_t{7430})));
}

TEST(Discovery, OtherDatagramsAreRefused) {
  EXPECT_EQ(std::get<Reject>(decodeDiscovery({})), Reject::Malformed);
  EXPECT_EQ(std::get<Reject>(decodeDiscovery(datagramOf(""))), Reject::Malformed);
  EXPECT_EQ(std::get<Reject>(decodeDiscovery(Bytes(kMaxDatagram + 1))), Reject::Oversized);
  Bytes sealed = encodeDiscovery(golden::announcement());
  sealed[3] = std::byte{kWireMajor};
  EXPECT_EQ(std::get<Reject>(decodeDiscovery(sealed)), Reject::Malformed);
  sealed[3] = std::byte{0};
  sealed[0] = std::byte{'X'};
  EXPECT_EQ(std::get<Reject>(decodeDiscovery(sealed)), Reject::Malformed);
}

TEST(Discovery, UnknownFieldsOfANewerMinorAreIgnored) {
  const auto extended = [](const Bytes& datagram) {
    return datagramOf(sealing::textOf(protobuf::withUnknownFields(protobuf::bytes(messageIn(datagram)))));
  };
  EXPECT_EQ(std::get<Search>(decodeDiscovery(extended(encodeDiscovery(Search{})))), Search{});
  EXPECT_EQ(std::get<Announcement>(decodeDiscovery(extended(encodeDiscovery(golden::announcement())))),
            golden::announcement());
}

RC_GTEST_PROP(Discovery, DamageNeverYieldsWhatCannotBe, ()) {
  const Bytes good = encodeDiscovery(arbitrary::announcement());
  for (std::size_t i = 0; i < good.size(); ++i) {
    RC_ASSERT(isRejectedOrValid(decodeDiscovery(std::span(good).first(i))));
    Bytes bad = good;
    bad[i] ^= static_cast<std::byte>(*rc::gen::inRange(1, 256));
    RC_ASSERT(isRejectedOrValid(decodeDiscovery(bad)));
  }
}

RC_GTEST_PROP(Discovery, RandomBytesNeverYieldWhatCannotBe, (const std::string& noise)) {
  RC_ASSERT(isRejectedOrValid(decodeDiscovery(protobuf::bytes(noise))));
  RC_ASSERT(isRejectedOrValid(decodeDiscovery(datagramOf(noise))));
}

}  // namespace
}  // namespace coherency
