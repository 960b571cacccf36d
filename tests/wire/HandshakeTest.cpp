#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/Handshake.h"
#include "tests/wire/SealSupport.h"

namespace coherency {
namespace {

using namespace sealing;

ConnectionKeys keysOf(const Handshake& mine, const Handshake& other, const Key& preshared,
                      std::span<const std::byte> client_opening, std::span<const std::byte> server_opening) {
  return mine.keys(other.publicKey(), preshared, client_opening, server_opening).value();
}

class HandshakeTest : public testing::Test {
 protected:
  const Handshake client_{countingKey(0)};
  const Handshake server_{countingKey(32)};
  const Key preshared_ = countingKey(64);
  const Bytes client_opening_ = bytesOf("client opening");
  const Bytes server_opening_ = bytesOf("server opening");
};

// The golden values are tests/wire/seal_reference.py's.

TEST_F(HandshakeTest, PublicKeysAreThoseOfAnotherImplementation) {
  EXPECT_EQ(hexOf(client_.publicKey()), "8f40c5adb68f25624ae5b214ea767a6ec94d829d3d7b5e1ad1ba6f3e2138285f");
  EXPECT_EQ(hexOf(server_.publicKey()), "358072d6365880d1aeea329adf9121383851ed21a28e3b75e965d0d2cd166254");
}

TEST_F(HandshakeTest, KeysAreThoseOfAnotherImplementation) {
  const auto keys = keysOf(client_, server_, preshared_, client_opening_, server_opening_);
  EXPECT_EQ(hexOf(keys.client_control), "bab5a4da56c4663e0c491005cf7e913dbfff612e78d2226212aa4cff1ce345fc");
  EXPECT_EQ(hexOf(keys.server_control), "bd85f2d3e9685790465e7a5a7d2b9df4aef1378264b36492dc9b776e146438dd");
  EXPECT_EQ(hexOf(keys.client_datagrams), "8eeaadef4476c49fa36dccab2f9521f70f17fc9536494a2654fa60be1a971617");
  EXPECT_EQ(hexOf(keys.server_datagrams), "9acf88ef90e31531e92b85ee14bb99173302bc3f2856424c46f625ead206e05c");
}

TEST_F(HandshakeTest, KeysWithoutAPresharedOneAreThoseOfAnotherImplementation) {
  const auto keys = keysOf(client_, server_, kNoKey, client_opening_, server_opening_);
  EXPECT_EQ(hexOf(keys.client_control), "bf2c51058c731db2e0f5c4a4ce1ceb08b4b58069099b81bc30f8aa294803af0d");
  EXPECT_EQ(hexOf(keys.server_control), "1278897c51bf914da93c79058d65a97cc8de7c86453f2f6f64e56b4cc3b261ca");
  EXPECT_EQ(hexOf(keys.client_datagrams), "5ee75f32a9370bedb5b4d11c491c885e0f5da1fd10e0b97691fad7ee3601e94f");
  EXPECT_EQ(hexOf(keys.server_datagrams), "062a649c6d14d3a7617fe5d6bd81b2fbdc3f35b11313f71c58b8331a70e9cc71");
}

RC_GTEST_PROP(HandshakeProperties, BothEndsHaveTheSameFourKeys, ()) {
  const Handshake client(arbitraryKey());
  const Handshake server(arbitraryKey());
  const Key preshared = arbitraryKey();
  const Bytes client_opening = arbitraryBytes(300);
  const Bytes server_opening = arbitraryBytes(300);
  const auto keys = keysOf(client, server, preshared, client_opening, server_opening);
  RC_ASSERT(keys == keysOf(server, client, preshared, client_opening, server_opening));
  const std::set<Key> distinct{keys.client_control, keys.server_control, keys.client_datagrams,
                               keys.server_datagrams};
  RC_ASSERT(distinct.size() == 4U);
  RC_ASSERT(!distinct.contains(kNoKey));
}

class Bound : public HandshakeTest {
 protected:
  void expectApart(const ConnectionKeys& others) const {
    const auto keys = keysOf(client_, server_, preshared_, client_opening_, server_opening_);
    EXPECT_NE(keys.client_control, others.client_control);
    EXPECT_NE(keys.server_control, others.server_control);
    EXPECT_NE(keys.client_datagrams, others.client_datagrams);
    EXPECT_NE(keys.server_datagrams, others.server_datagrams);
  }
};

TEST_F(Bound, ToEveryBitOfThePresharedKey) {
  for (std::size_t bit = 0; bit < 256; ++bit) {
    Key other = preshared_;
    other[bit / 8] ^= std::byte{1} << (bit % 8);
    expectApart(keysOf(server_, client_, other, client_opening_, server_opening_));
  }
}

TEST_F(Bound, ToEveryBitOfBothOpenings) {
  for (std::size_t bit = 0; bit < 8 * client_opening_.size(); ++bit) {
    expectApart(keysOf(server_, client_, preshared_, flipped(client_opening_, bit), server_opening_));
    expectApart(keysOf(server_, client_, preshared_, client_opening_, flipped(server_opening_, bit)));
  }
}

TEST_F(Bound, ToWhoSaidWhat) {
  expectApart(keysOf(server_, client_, preshared_, server_opening_, client_opening_));
  expectApart(keysOf(server_, client_, preshared_, bytesOf("client openings"), bytesOf("erver opening")));
  expectApart(keysOf(server_, client_, preshared_, {}, bytesOf("client openingserver opening")));
}

TEST_F(Bound, ToBothSecrets) {
  const Handshake other(countingKey(1));
  expectApart(keysOf(other, server_, preshared_, client_opening_, server_opening_));
  expectApart(keysOf(client_, other, preshared_, client_opening_, server_opening_));
}

// The points of order 1, 2, 4 and 8 of the curve and its twist, and those again as numbers of 2^255 - 19 and
// more (RFC 7748 takes them, and ignores the highest bit): https://cr.yp.to/ecdh.html#validate.
constexpr std::array<std::string_view, 7> kLowOrder{
    "0000000000000000000000000000000000000000000000000000000000000000",
    "0100000000000000000000000000000000000000000000000000000000000000",
    "e0eb7a7c3b41b8ae1656e3faf19fc46ada098deb9c32b1fd866205165f49b800",
    "5f9c95bca3508c24b1d0b1559c83ef5b04445cc4581c8e86d8224eddd09f1157",
    "ecffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f",
    "edffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f",
    "eeffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f",
};

TEST_F(HandshakeTest, PointsOfLowOrderAreNoPublicKeys) {
  for (const std::string_view hex : kLowOrder) {
    Key point = keyOfHex(hex);
    EXPECT_FALSE(client_.keys(point, preshared_, client_opening_, server_opening_)) << hex;
    point.back() |= std::byte{0x80};
    EXPECT_FALSE(client_.keys(point, preshared_, client_opening_, server_opening_))
        << hex << " and the highest bit";
  }
  EXPECT_TRUE(client_.keys(server_.publicKey(), preshared_, client_opening_, server_opening_));
}

TEST(RandomKey, IsAnotherEachTime) {
  std::set<Key> keys;
  for (int i = 0; i < 100; ++i) keys.insert(randomKey());
  EXPECT_EQ(keys.size(), 100U);
  EXPECT_FALSE(keys.contains(kNoKey));
}

}  // namespace
}  // namespace coherency
