#include <gtest/gtest.h>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/DatagramCodec.h"
#include "common/wire/Validity.h"
#include "tests/wire/Generators.h"
#include "tests/wire/GoldenPackets.h"

namespace coherency {
namespace {

// What is frozen here is what other people's clients speak. A change that breaks one of these needs another
// major version; a field added at the end of a message, another minor.

constexpr std::string_view kMotion =
    "434f48020ae103098877665544332211126208ea0711805e5e10e90000001892a87a20ffbf1f2a4cea03000060011200"
    "185200002f79000046a000005dc7000074ee00008b150100a23c0100b9630100d08a0100e7b10100fed8010015000200"
    "2c270200434e02005a750200719c020088c302001aa00108ea0710011a200a12089693d89fee4718e1a2f3ad0725c0bd"
    "f0ff10a0c21e18ffd3612080800822160a0e08fface204100e181225000000401002180320062802322408021080897a"
    "18ff91f40120809bee022a10000000200000002000000020000000204005322910aab4de7518c0c7efc80520e1a2f3ad"
    "072a1000000000000000000000000000000040309e990138013a06008080808004420408111801211807f6e5d4c3b2a1"
    "2a6208e90711401c4f10e900000018c2987a20ffbf1f2a4ce903000060011200175200002e79000045a000005cc70000"
    "73ee00008a150100a13c0100b8630100cf8a0100e6b10100fdd80100140002002b270200424e020059750200709c0200"
    "87c302002a6208e8071100da3f10e900000018f2887a20ffbf1f2a4ce803000060011200165200002d79000044a00000"
    "5bc7000072ee000089150100a03c0100b7630100ce8a0100e5b10100fcd80100130002002a270200414e020058750200"
    "6f9c020086c30200";
constexpr std::string_view kProbe = "434f4802121d09887766554433221110071900ffeeddccbbaa9921141a99be1c000000";
constexpr std::string_view kReply =
    "434f48021a2409887766554433221111141a99be1c0000001900f2052a01000000213922062a01000000";
constexpr std::string_view kHello =
    "000000230a2108021a046c6566742217636f686572656e63792072656e6465725f636c69656e74";
constexpr std::string_view kWelcome =
    "00000287128405080219887766554433221120072900ffeeddccbbaa9932a0010a0a6c61626f7261746f727910011801"
    "22061880f28ba8092a0618fff7cea303321108ffcfacf30e18ff9ba3e00e25000000c03a0b18ff9ba3e00e2500000080"
    "42160a057461626c6512057461626c651a0618ffafb4f80842330a05626c6f636b120972656420626c6f636b1a1608ff"
    "b3891310c0c7efc80518ffcd91b007250000000822072363383433336142110a04677269641204677269641a0028e807"
    "3a0764656661756c7442170a0c6579655f64697374616e636511fca9f1d24d62b03f42160a0b6579655f666f72776172"
    "6411c3f5285c8fc2b53f42110a066579655f757011b81e85eb51b89e3f42160a0b6e65636b5f6c656e67746811ec51b8"
    "1e85ebc13f42140a096e65636b5f6261636b11b81e85eb51b89e3f42170a0c7472756e6b5f6c656e67746811a4703d0a"
    "d7a3e03f421e0a1373686f756c6465725f68616c665f77696474681152b81e85eb51c83f42180a0d73686f756c646572"
    "5f64726f70119a9999999999a93f421b0a1073686f756c6465725f74696c745f757011a915a15ddeecdb3f421d0a1273"
    "686f756c6465725f74696c745f6261636b1165732d3852c1e03f42140a0975707065725f61726d118fc2f5285c8fd23f"
    "42120a07666f726561726d11a4703d0ad7a3d03f420f0a0468616e64110ad7a3703d0ab73f42160a0b736561745f6865"
    "6967687411000000000000e03f42190a0e6869705f68616c665f7769647468110ad7a3703d0ab73f42100a0574686967"
    "681185eb51b81e85db3f420f0a047368696e11e17a14ae47e1da3f420f0a04666f6f7411000000000000d03f42160a0b"
    "726f626f745f7363616c6511000000000000f03f48c0843d50863a";
constexpr std::string_view kReport =
    "000000351a330a1508e8071108070605040302011900f2052a010000000a1508f807111817161514131211192b42042b"
    "0100000010f8071803";
constexpr std::string_view kGoodbye = "0000001322110a0f7468652073657276657220656e6473";
constexpr std::string_view kModeRequest = "000000042a020801";
constexpr std::string_view kRefusal = "0000001522130a0f616e6f746865722076657273696f6e1001";

std::vector<std::byte> bytesOf(std::string_view hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
  }
  return bytes;
}

std::string hexOf(std::span<const std::byte> bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::byte b : bytes) {
    text += digits[std::to_integer<std::size_t>(b) >> 4];
    text += digits[std::to_integer<std::size_t>(b) & 15];
  }
  return text;
}

template <class T>
void expectDatagram(const T& value, std::string_view frozen) {
  ASSERT_TRUE(isValid(value));
  DatagramCodec codec;
  std::vector<std::byte> bytes;
  codec.encode(value, bytes);
  EXPECT_EQ(hexOf(bytes), frozen);
  const DecodedDatagram decoded = codec.decode(bytesOf(frozen));
  ASSERT_TRUE(std::holds_alternative<T>(decoded));
  EXPECT_EQ(std::get<T>(decoded), value);
}

template <class T>
T expectControl(const T& value, std::string_view frozen) {
  EXPECT_TRUE(isValid(value));
  EXPECT_EQ(hexOf(encodeControl(value)), frozen);
  const std::vector<std::byte> bytes = bytesOf(frozen);
  return std::get<T>(decodeControl(std::span(bytes).subspan(kControlPrefix)));
}

TEST(GoldenBytes, Motion) {
  expectDatagram(golden::motion(), kMotion);
}
TEST(GoldenBytes, ClockProbe) {
  expectDatagram(golden::probe(), kProbe);
}
TEST(GoldenBytes, ClockReply) {
  expectDatagram(golden::reply(), kReply);
}

TEST(GoldenBytes, Hello) {
  EXPECT_EQ(expectControl(golden::hello(), kHello), golden::hello());
}
TEST(GoldenBytes, Report) {
  EXPECT_EQ(expectControl(golden::report(), kReport), golden::report());
}
TEST(GoldenBytes, Goodbye) {
  EXPECT_EQ(expectControl(golden::goodbye(), kGoodbye), golden::goodbye());
  EXPECT_EQ(expectControl(golden::refusal(), kRefusal), golden::refusal());
}
TEST(GoldenBytes, ModeRequest) {
  EXPECT_EQ(expectControl(golden::modeRequest(), kModeRequest), golden::modeRequest());
}
TEST(GoldenBytes, Welcome) {
  EXPECT_TRUE(arbitrary::same(expectControl(golden::session(), kWelcome), golden::session()));
}

}  // namespace
}  // namespace coherency
