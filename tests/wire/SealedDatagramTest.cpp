#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/SealedDatagram.h"
#include "tests/wire/SealSupport.h"

namespace coherency {
namespace {

using namespace sealing;
using Opened = std::variant<Reject, std::span<const std::byte>>;

constexpr std::uint32_t kChannel = 0x01020304;
constexpr std::size_t kLongestBody = kMaxDatagram - kSealedHeader - kSealTag;

Bytes sealed(DatagramSealer& sealer, std::span<const std::byte> body) {
  Bytes datagram;
  sealer.begin(datagram);
  datagram.insert(datagram.end(), body.begin(), body.end());
  sealer.seal(datagram);
  return datagram;
}

/// Of a copy, as a datagram may be opened again.
std::variant<Reject, Bytes> opened(DatagramOpener& opener, Bytes datagram) {
  const Opened result = opener.open(datagram);
  if (const Reject* reject = std::get_if<Reject>(&result)) return *reject;
  return copyOf(std::get<1>(result));
}

class SealedDatagram : public testing::Test {
 protected:
  Bytes sealNext(std::string_view text) { return sealed(sealer_, bytesOf(text)); }
  void expectOpens(const Bytes& datagram, std::string_view text) {
    const auto result = opened(opener_, datagram);
    ASSERT_TRUE(std::holds_alternative<Bytes>(result));
    EXPECT_EQ(textOf(std::get<Bytes>(result)), text);
  }
  void expectRefused(const Bytes& datagram, Reject cause) {
    const auto result = opened(opener_, datagram);
    ASSERT_TRUE(std::holds_alternative<Reject>(result));
    EXPECT_EQ(std::get<Reject>(result), cause);
  }

  DatagramSealer sealer_{countingKey(0), kChannel};
  DatagramOpener opener_{countingKey(0), kChannel};
};

TEST_F(SealedDatagram, IsTheBytesThatAnotherImplementationMakes) {
  // tests/wire/seal_reference.py
  EXPECT_EQ(hexOf(sealNext("coherency")),
            "434f480301020304000000000000000159d65187731a3df7d00a79b219493bb0377b04a770d2b5e1ec");
  EXPECT_EQ(hexOf(sealNext("coherency")),
            "434f4803010203040000000000000002454fdf95cdfb85fc902564639f770cb89a1cb263a1ac536571");
}

RC_GTEST_PROP(SealedDatagramProperties, AnyBodyComesBack, ()) {
  const Key key = arbitraryKey();
  const auto channel = *rc::gen::arbitrary<std::uint32_t>();
  DatagramSealer sealer(key, channel);
  DatagramOpener opener(key, channel);
  for (std::uint64_t counter = 1; counter < 4; ++counter) {
    const Bytes body = arbitraryBytes(kLongestBody);
    const Bytes datagram = sealed(sealer, body);
    RC_ASSERT(datagram.size() == kSealedHeader + body.size() + kSealTag);
    RC_ASSERT(std::get<DatagramHeader>(readHeader(datagram)) == (DatagramHeader{channel, counter}));
    RC_ASSERT(std::get<Bytes>(opened(opener, datagram)) == body);
  }
}

TEST_F(SealedDatagram, HoldsNothingAndTheMost) {
  expectOpens(sealNext(""), "");
  const std::string most(kLongestBody, 'x');
  const Bytes datagram = sealNext(most);
  EXPECT_EQ(datagram.size(), kMaxDatagram);
  expectOpens(datagram, most);
}

TEST_F(SealedDatagram, IsMadeAndOpenedWhereItLies) {
  Bytes datagram;
  datagram.reserve(kMaxDatagram);
  const std::byte* place = datagram.data();
  for (int i = 0; i < 3; ++i) {
    sealer_.begin(datagram);
    EXPECT_EQ(datagram.size(), kSealedHeader);
    datagram.resize(kSealedHeader + 100);
    sealer_.seal(datagram);
    EXPECT_EQ(datagram.data(), place);
    const Opened result = opener_.open(datagram);
    EXPECT_EQ(std::get<1>(result).data(), place + kSealedHeader);
    EXPECT_EQ(std::get<1>(result).size(), 100U);
  }
}

TEST_F(SealedDatagram, EveryFlippedBitIsFoundAndChangesNothing) {
  const Bytes good = sealNext("a body of some length, longer than one block of the cipher's 64 bytes");
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    SCOPED_TRACE(bit);
    expectRefused(flipped(good, bit), bit < 24   ? Reject::Malformed
                                      : bit < 32 ? Reject::Version
                                                 : Reject::Forged);
  }
  expectOpens(good, "a body of some length, longer than one block of the cipher's 64 bytes");
}

TEST_F(SealedDatagram, EveryLengthButItsOwnIsRefused) {
  const Bytes good = sealNext("a body");
  for (std::size_t size = 0; size < good.size(); ++size) {
    SCOPED_TRACE(size);
    const Bytes cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    expectRefused(cut, size < kSealedHeader + kSealTag ? Reject::Malformed : Reject::Forged);
  }
  for (std::size_t size = good.size() + 1; size <= kMaxDatagram + 1; ++size) {
    SCOPED_TRACE(size);
    Bytes longer = good;
    longer.resize(size);
    expectRefused(longer, size > kMaxDatagram ? Reject::Oversized : Reject::Forged);
  }
  expectOpens(good, "a body");
}

TEST_F(SealedDatagram, AnotherVersionIsToldHoweverShort) {
  expectRefused(bytesOf("COH\x02"), Reject::Version);
  expectRefused(bytesOf("COH\x04 and more"), Reject::Version);
  expectRefused(bytesOf("COH\x03"), Reject::Malformed);
  expectRefused(bytesOf("COH"), Reject::Malformed);
}

TEST_F(SealedDatagram, PassesOnce) {
  const Bytes first = sealNext("first");
  expectOpens(first, "first");
  expectRefused(first, Reject::Replayed);
  expectOpens(sealNext("second"), "second");
  expectRefused(first, Reject::Replayed);
}

TEST_F(SealedDatagram, MayBeOvertakenWithinTheWindow) {
  std::vector<Bytes> sent;
  for (std::size_t i = 0; i <= kReplayWindow; ++i) sent.push_back(sealNext(std::to_string(i)));
  expectOpens(sent[kReplayWindow], std::to_string(kReplayWindow));
  for (std::size_t i = kReplayWindow; i-- > 1;) expectOpens(sent[i], std::to_string(i));
  expectRefused(sent[0], Reject::Replayed);
  expectRefused(sent[1], Reject::Replayed);
}

TEST_F(SealedDatagram, AForgedCounterFarAheadLeavesTheWindow) {
  const Bytes good = sealNext("good");
  Bytes forged = good;
  for (std::size_t i = 8; i < 16; ++i) forged[i] = std::byte{0xff};
  expectRefused(forged, Reject::Forged);
  expectOpens(good, "good");
}

TEST_F(SealedDatagram, AGenuineCounterFarAheadIsFollowed) {
  const Bytes late = sealNext("late");
  for (std::size_t i = 0; i < 3 * kReplayWindow; ++i) sealNext("lost");
  expectOpens(sealNext("new"), "new");
  expectRefused(late, Reject::Replayed);
}

TEST_F(SealedDatagram, OfAnotherChannelOrKeyIsForged) {
  const Bytes good = sealNext("good");
  for (const std::uint32_t channel : {0U, 1U, kChannel + 1}) {
    DatagramSealer other(countingKey(0), channel);
    expectRefused(sealed(other, bytesOf("good")), Reject::Forged);
  }
  for (std::size_t bit = 0; bit < 256; ++bit) {
    Key key = countingKey(0);
    key[bit / 8] ^= std::byte{1} << (bit % 8);
    DatagramSealer other(key, kChannel);
    expectRefused(sealed(other, bytesOf("good")), Reject::Forged);
  }
  expectOpens(good, "good");
}

RC_GTEST_PROP(SealedDatagramProperties, NoiseIsRefused, ()) {
  DatagramOpener opener(countingKey(0), kChannel);
  Bytes noise = arbitraryBytes(kMaxDatagram + 10);
  RC_ASSERT(std::holds_alternative<Reject>(opened(opener, noise)));
  DatagramSealer sealer(countingKey(1), kChannel);
  const Bytes of_another_key = sealed(sealer, {});
  std::copy(of_another_key.begin(), of_another_key.begin() + kSealedHeader,
            noise.insert(noise.begin(), kSealedHeader, std::byte{}));
  RC_ASSERT(std::holds_alternative<Reject>(opened(opener, noise)));
}

}  // namespace
}  // namespace coherency
