#include <gtest/gtest.h>

#include "common/wire/ControlChannel.h"
#include "common/wire/DatagramCodec.h"
#include "common/wire/SealedDatagram.h"
#include "common/wire/Validity.h"
#include "tests/wire/GoldenMessages.h"
#include "tests/wire/GoldenPackets.h"
#include "tests/wire/Hex.h"
#include "tests/wire/MessageGenerators.h"

namespace coherency {
namespace {

using sealing::Bytes;
using sealing::countingKey;
using sealing::hexOf;

// What is frozen here is what other people's clients speak. A change that breaks one of these needs another
// major version; a field added at the end of a message, another minor.

constexpr std::string_view kMotion =
    "0adc050803126208ea0711805e5e10e90000001892a87a20ffbf1f2a4cea03000060011200185200002f79000046a000005d"
    "c7000074ee00008b150100a23c0100b9630100d08a0100e7b10100fed80100150002002c270200434e02005a750200719c02"
    "0088c302001a7508cc011001180222200a120896eb81e6e64718e18e88d103256079feff10a0c21e18ffd361208080083209"
    "081110b607180120013a27100218fffab45e20bfd9e3ca0528e2bde1b0073210000000200000002000000020000000204001"
    "3a0c080220bf843d389e9901480542080801108080808004211807f6e5d4c3b2a12a6208e90711401c4f10e900000018c298"
    "7a20ffbf1f2a4ce903000060011200175200002e79000045a000005cc7000073ee00008a150100a13c0100b8630100cf8a01"
    "00e6b10100fdd80100140002002b270200424e020059750200709c020087c302002a6208e8071100da3f10e900000018f288"
    "7a20ffbf1f2a4ce803000060011200165200002d79000044a000005bc7000072ee000089150100a03c0100b7630100ce8a01"
    "00e5b10100fcd80100130002002a270200414e0200587502006f9c020086c302003294010815126208ff0711c0cd9e11e900"
    "000018a2f07c20ffbf1f2a4cff030000600112002d520000447900005ba0000072c7000089ee0000a0150100b73c0100ce63"
    "0100e58a0100fcb1010013d901002a00020041270200584e02006f750200869c02009dc302001a23082a1001180222060a04"
    "18ff887a3a0c0802209f9c01389e9901480542050802109c01213d1706f5e4d3c2b13294010814126208fe0711808b8f11e9"
    "00000018d2e07c20ffbf1f2a4cfe030000600112002c520000437900005aa0000071c7000088ee00009f150100b63c0100cd"
    "630100e48a0100fbb1010012d901002900020040270200574e02006e750200859c02009cc302001a2308281001180222060a"
    "0418ff887a3a0c0802209f9c01389e9901480542050802109c01213c1706f5e4d3c2b1";
constexpr std::string_view kMotionInCodes =
    "0a9c040803123c08ea0711805e5e10e90000001892a87a20ffbf1f32260280c1a54480ff7f00800080565501800180d70802"
    "800280038008000380048004800a000b001a7508cc011001180222200a120896eb81e6e64718e18e88d103256079feff10a0"
    "c21e18ffd361208080083209081110b607180120013a27100218fffab45e20bfd9e3ca0528e2bde1b0073210000000200000"
    "0020000000200000002040013a0c080220bf843d389e9901480542080801108080808004211807f6e5d4c3b2a12a3c08e907"
    "11401c4f10e900000018c2987a20ffbf1f32260280c1a54480ff7f00800080565501800180d7080280028003800800038004"
    "8004800a000b002a3c08e8071100da3f10e900000018f2887a20ffbf1f32260280c1a54480ff7f00800080565501800180d7"
    "0802800280038008000380048004800a000b00326e0815123c08ff0711c0cd9e11e900000018a2f07c20ffbf1f32260280c1"
    "a54480ff7f00800080565501800180d70802800280038008000380048004800a000b001a23082a1001180222060a0418ff88"
    "7a3a0c0802209f9c01389e9901480542050802109c01213d1706f5e4d3c2b1326e0814123c08fe0711808b8f11e900000018"
    "d2e07c20ffbf1f32260280c1a54480ff7f00800080565501800180d70802800280038008000380048004800a000b001a2308"
    "281001180222060a0418ff887a3a0c0802209f9c01389e9901480542050802109c01213c1706f5e4d3c2b1";
constexpr std::string_view kMotionOfTheHead =
    "0acc030803122c08ea0711805e5e10e90000001892a87a203f2a18ea03000060011200185200002f79000046a000005dc700"
    "001a7508cc011001180222200a120896eb81e6e64718e18e88d103256079feff10a0c21e18ffd361208080083209081110b6"
    "07180120013a27100218fffab45e20bfd9e3ca0528e2bde1b00732100000002000000020000000200000002040013a0c0802"
    "20bf843d389e9901480542080801108080808004211807f6e5d4c3b2a12a2c08e90711401c4f10e900000018c2987a203f2a"
    "18e903000060011200175200002e79000045a000005cc700002a2c08e8071100da3f10e900000018f2887a203f2a18e80300"
    "0060011200165200002d79000044a000005bc70000325e0815122c08ff0711c0cd9e11e900000018a2f07c203f2a18ff0300"
    "00600112002d520000447900005ba0000072c700001a23082a1001180222060a0418ff887a3a0c0802209f9c01389e990148"
    "0542050802109c01213d1706f5e4d3c2b1325e0814122c08fe0711808b8f11e900000018d2e07c203f2a18fe030000600112"
    "002c520000437900005aa0000071c700001a2308281001180222060a0418ff887a3a0c0802209f9c01389e99014805420508"
    "02109c01213c1706f5e4d3c2b1";
constexpr std::string_view kProbe = "120d09141a99be1c00000010031801";
constexpr std::string_view kReply = "1a1b09141a99be1c0000001100f2052a01000000193922062a01000000";
constexpr std::string_view kHello =
    "0a2608032a200102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f203001";
constexpr std::string_view kJoin = "321f0a046c6566741217636f686572656e63792072656e6465725f636c69656e74";
constexpr std::string_view kWelcome =
    "12830609887766554433221110071aa0010a0a6c61626f7261746f72791001180122061880f28ba8092a0618fff7cea30332"
    "1108ffcfacf30e18ff9ba3e00e25000000c03a0b18ff9ba3e00e250000008042160a057461626c6512057461626c651a0618"
    "ffafb4f80842330a05626c6f636b120972656420626c6f636b1a1608ffb3891310c0c7efc80518ffcd91b007250000000822"
    "072363383433336142110a04677269641204677269641a0028e807220764656661756c742a170a0c6579655f64697374616e"
    "636511fca9f1d24d62b03f2a160a0b6579655f666f727761726411c3f5285c8fc2b53f2a110a066579655f757011b81e85eb"
    "51b89e3f2a160a0b6e65636b5f6c656e67746811ec51b81e85ebc13f2a140a096e65636b5f6261636b11b81e85eb51b89e3f"
    "2a170a0c7472756e6b5f6c656e67746811a4703d0ad7a3e03f2a1e0a1373686f756c6465725f68616c665f77696474681152"
    "b81e85eb51c83f2a180a0d73686f756c6465725f64726f70119a9999999999a93f2a1b0a1073686f756c6465725f74696c74"
    "5f757011a915a15ddeecdb3f2a1d0a1273686f756c6465725f74696c745f6261636b1165732d3852c1e03f2a140a09757070"
    "65725f61726d118fc2f5285c8fd23f2a120a07666f726561726d11a4703d0ad7a3d03f2a0f0a0468616e64110ad7a3703d0a"
    "b73f2a160a0b736561745f68656967687411000000000000e03f2a190a0e6869705f68616c665f7769647468110ad7a3703d"
    "0ab73f2a100a0574686967681185eb51b81e85db3f2a0f0a047368696e11e17a14ae47e1da3f2a0f0a04666f6f7411000000"
    "000000d03f2a160a0b726f626f745f7363616c6511000000000000f03f30c0843d38863a42202122232425262728292a2b2c"
    "2d2e2f303132333435363738393a3b3c3d3e3f4048ffff17524c000000000100000002000000030000000400000005000000"
    "060000000700000008000000090000000a0000000b0000000c0000000d0000000e0000000f00000010000000110000001200"
    "0000580160aba0f9076a0a3233392e372e34332e3070883a";
constexpr std::string_view kKeyframe =
    "3ac90108031003180322c00108880e22130a110880a8d6b90718ff93ebdc03256044f2ff2a160a0e08fface204100e181225"
    "00000040100218032006320208113a25188084af5f20c0c7efc80528e1a2f3ad073210000000000000000000000000000000"
    "4040013a280801188088debe0120c0c7efc80528e1a2f3ad0732100000000000000000000000000000004040013a28080218"
    "808c8d9e0220c0c7efc80528e1a2f3ad07321000000000000000000000000000000040400142080801108080808008420508"
    "02109a01";
constexpr std::string_view kKeyframeRequest = "4200";
constexpr std::string_view kReport =
    "1a4b0a2708e80718e0d4032108070605040302012900f2052a0100000031c05ed1270100000038c0a8a5040a1b08"
    "e907100318f1d403211817161514131211316009c7280100000010f8071803";
constexpr std::string_view kModeRequest = "2a020801";
constexpr std::string_view kTunnelled = "4a1674686520626f6479206f66206120646174616772616d";
constexpr std::string_view kGoodbye = "22110a0f7468652073657276657220656e6473";
constexpr std::string_view kRefusal = "22130a0f616e6f746865722076657273696f6e1001";
constexpr std::string_view kAnnouncement =
    "434f4800122008031a096d6f74696f6e2d7063220a6c61626f7261746f727928863a30013802";
// Without its padding, kSearchSize zeros.
constexpr std::string_view kSearch = "434f48000a85040803128004";
// The functions of seal_reference.py make the same of the bodies above.
constexpr std::string_view kSealedProbe =
    "434f4803000000070000000000000001840c9b2283f5e25c5e2f8ec3e263477808bb47eae9ba190de78c16be5b9cea";
constexpr std::string_view kSaidByClient =
    "000000280a2608032a208f40c5adb68f25624ae5b214ea767a6ec94d829d3d7b5e1ad1ba6f3e2138285f30010000003201bd"
    "9d70bace40798f256c752c07fe2151f6818d10ce9afad99135e91476eb66f3d63420d4b439b0fa0fe49fb01e1bb28a360000"
    "001501e6ac279087135350abe9c25ecbbd08aef8e79ef5";
constexpr std::string_view kSaidByServer =
    "000000280a2608032a20358072d6365880d1aeea329adf9121383851ed21a28e3b75e965d0d2cd1662543001000000dd01a4"
    "0b9cb2ef9f6ff49f33e1c03049be6e7ada16d2ff604edb28119a0c57afca0fe74d33f4030708dc84cae143ca1f45d44090b1"
    "5ecc50ce954a417b35d79d4d3daf752044b03755b1b730a9819e649f69d2a3acabc8e015e566e768785851feb345ac00c9ee"
    "f2f7850b1d80a688b4d04e8725b3eac1332c15dd40b948d2d11a24b6d292f63953c4e509c0ba8a535e11fb7cff6b6d06f6d2"
    "f2f773616a3ea583092b433eb82e659b7f98b3af887f27016724688ff7bf1a316add8ed8dd7b10f725cfdd70aa071db9e837"
    "657c0f91df499eec4c8462a6a7a94fdd1aaaac0000002401edc0b2b5bde6aba96acc1e0362813b14363597521758b1cd5efd"
    "5df65b58ddb691b378";

KeyframeStore keyframes() {
  KeyframeStore store;
  store.add(golden::keyframe());
  return store;
}

template <class T>
void expectDecodes(const T& value, const SampleForm& form, const Bytes& bytes) {
  const DecodedDatagram decoded = DatagramCodec(form).decode(bytes, keyframes());
  ASSERT_TRUE(std::holds_alternative<T>(decoded));
  EXPECT_EQ(std::get<T>(decoded), value);
}

void expectMotion(const SampleForm& form, std::string_view frozen) {
  const MotionPacket packet = golden::motion(form);
  ASSERT_TRUE(isValid(packet));
  Bytes bytes;
  DatagramCodec(form).encode(packet, golden::keyframe().world, bytes);
  EXPECT_EQ(hexOf(bytes), frozen);
  expectDecodes(packet, form, bytesOfHex(frozen));
}

template <class T>
void expectDatagram(const T& value, std::string_view frozen) {
  ASSERT_TRUE(isValid(value));
  Bytes bytes;
  DatagramCodec().encode(value, bytes);
  EXPECT_EQ(hexOf(bytes), frozen);
  expectDecodes(value, {}, bytesOfHex(frozen));
}

void expectControl(const ControlMessage& value, std::string_view frozen) {
  Bytes bytes;
  encodeControl(value, bytes);
  EXPECT_EQ(hexOf(bytes), frozen);
  const DecodedControl decoded = decodeControl(bytesOfHex(frozen));
  ASSERT_TRUE(std::holds_alternative<ControlMessage>(decoded));
  EXPECT_TRUE(arbitrary::same(std::get<ControlMessage>(decoded), value));
}

TEST(GoldenBytes, Motion) {
  expectMotion({}, kMotion);
}
TEST(GoldenBytes, MotionInCodes) {
  expectMotion(golden::codes(), kMotionInCodes);
}
TEST(GoldenBytes, MotionOfTheHeadOnly) {
  expectMotion(golden::headOnly(), kMotionOfTheHead);
}
TEST(GoldenBytes, ClockProbe) {
  expectDatagram(golden::probe(), kProbe);
}
TEST(GoldenBytes, ClockReply) {
  expectDatagram(golden::reply(), kReply);
}

TEST(GoldenBytes, Hello) {
  expectControl(golden::hello(), kHello);
}
TEST(GoldenBytes, Join) {
  expectControl(golden::join(), kJoin);
}
TEST(GoldenBytes, Welcome) {
  expectControl(golden::session(), kWelcome);
}
TEST(GoldenBytes, Keyframe) {
  expectControl(golden::keyframe(), kKeyframe);
}
TEST(GoldenBytes, KeyframeRequest) {
  expectControl(KeyframeRequest{}, kKeyframeRequest);
}
TEST(GoldenBytes, Report) {
  expectControl(golden::report(), kReport);
}
TEST(GoldenBytes, ModeRequest) {
  expectControl(golden::modeRequest(), kModeRequest);
}
TEST(GoldenBytes, Tunnelled) {
  expectControl(golden::tunnelled(), kTunnelled);
}
TEST(GoldenBytes, Goodbye) {
  expectControl(golden::goodbye(), kGoodbye);
  expectControl(golden::refusal(), kRefusal);
}

TEST(GoldenBytes, Announcement) {
  EXPECT_EQ(hexOf(encodeDiscovery(golden::announcement())), kAnnouncement);
  EXPECT_EQ(std::get<Announcement>(decodeDiscovery(bytesOfHex(kAnnouncement))), golden::announcement());
}
TEST(GoldenBytes, Search) {
  const std::string frozen = std::string(kSearch) + std::string(2 * kSearchSize, '0');
  EXPECT_EQ(hexOf(encodeDiscovery(Search{})), frozen);
  EXPECT_EQ(std::get<Search>(decodeDiscovery(bytesOfHex(frozen))), Search{});
}

TEST(GoldenBytes, ASealedDatagram) {
  DatagramSealer sealer(countingKey(0), 7);
  Bytes datagram;
  sealer.begin(datagram);
  DatagramCodec().encode(golden::probe(), datagram);
  sealer.seal(datagram);
  EXPECT_EQ(hexOf(datagram), kSealedProbe);
}

/// The next message that the channel has heard.
template <class T>
T said(ControlChannel& channel) {
  return std::get<T>(std::get<ControlMessage>(channel.next().value()));
}

TEST(GoldenBytes, AConversation) {
  using Side = ControlChannel::Side;
  const Key preshared = countingKey(64);
  ControlChannel client(Side::Client, preshared, countingKey(0));
  ControlChannel server(Side::Server, preshared, countingKey(32));
  Bytes said_by_client;
  Bytes said_by_server;
  client.write(client.hello(), said_by_client);
  server.feed(said_by_client);
  const std::size_t clear = said_by_client.size();
  server.write(server.hello(), said_by_server);
  client.feed(said_by_server);
  ASSERT_TRUE(server.agree(said<Hello>(server)));
  ASSERT_TRUE(client.agree(said<Hello>(client)));
  client.write(golden::join(), said_by_client);
  client.write(golden::modeRequest(), said_by_client);
  server.feed(std::span(said_by_client).subspan(clear));
  EXPECT_EQ(said<Join>(server), golden::join());
  EXPECT_EQ(said<ModeRequest>(server), golden::modeRequest());
  server.write(golden::keyframe(), said_by_server);
  server.write(golden::goodbye(), said_by_server);
  EXPECT_EQ(hexOf(said_by_client), kSaidByClient);
  EXPECT_EQ(hexOf(said_by_server), kSaidByServer);
}

}  // namespace
}  // namespace coherency
