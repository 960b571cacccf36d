#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/ControlChannel.h"
#include "tests/wire/GoldenMessages.h"
#include "tests/wire/Hex.h"
#include "tests/wire/MessageGenerators.h"
#include "tests/wire/Protobuf.h"

namespace coherency {
namespace {

using sealing::Bytes;
using sealing::countingKey;
using Side = ControlChannel::Side;

Bytes written(ControlChannel& channel, const ControlMessage& message) {
  Bytes out;
  channel.write(message, out);
  return out;
}
Bytes framed(const Bytes& message) {
  Bytes out(kControlPrefix);
  out.insert(out.end(), message.begin(), message.end());
  finishControlFrame(out, 0);
  return out;
}

DecodedControl heard(ControlChannel& channel, std::span<const std::byte> stream) {
  channel.feed(stream);
  auto message = channel.next();
  if (!message) throw std::runtime_error("no whole message came");
  return *message;
}
template <class T>
T hears(ControlChannel& channel, std::span<const std::byte> stream) {
  return std::get<T>(std::get<ControlMessage>(heard(channel, stream)));
}
Reject refusal(ControlChannel& channel, std::span<const std::byte> stream) {
  return std::get<Reject>(heard(channel, stream));
}

/// Both ends, with the secrets that one gives them.
struct Ends {
  explicit Ends(const Key& of_client = countingKey(64), const Key& of_server = countingKey(64),
                int secrets = 0)
      : client(Side::Client, of_client, countingKey(secrets)),
        server(Side::Server, of_server, countingKey(secrets + 32)) {}

  /// Both hellos, which pass through `on_the_way`.
  void agree(Bytes (*on_the_way)(Bytes) = [](Bytes hello) { return hello; }) {
    const Hello of_client = hears<Hello>(server, on_the_way(written(client, client.hello())));
    const Hello of_server = hears<Hello>(client, written(server, server.hello()));
    ASSERT_TRUE(server.agree(of_client));
    ASSERT_TRUE(client.agree(of_server));
  }

  ControlChannel client;
  ControlChannel server;
};

/// Feeds it in pieces of any size, and gives what came out.
std::vector<ControlMessage> chopped(ControlChannel& channel, const Bytes& stream) {
  std::vector<ControlMessage> messages;
  for (std::size_t at = 0; at < stream.size();) {
    const std::size_t size = std::min(*rc::gen::inRange<std::size_t>(1, 400), stream.size() - at);
    channel.feed(std::span(stream).subspan(at, size));
    while (const auto message = channel.next()) messages.push_back(std::get<ControlMessage>(*message));
    at += size;
  }
  return messages;
}

RC_GTEST_PROP(ControlChannelProperties, AConversationArrivesHoweverItIsChopped, ()) {
  const Key preshared = sealing::arbitraryKey();
  Ends ends(preshared, preshared, *rc::gen::inRange(0, 100));
  ends.agree();
  for (ControlChannel* const speaker : {&ends.client, &ends.server}) {
    ControlChannel& listener = speaker == &ends.client ? ends.server : ends.client;
    std::vector<ControlMessage> said = arbitrary::oneOfEach();
    said.erase(said.begin());  // the hello has been said
    Bytes stream;
    for (const ControlMessage& message : said) speaker->write(message, stream);
    const auto heard = chopped(listener, stream);
    RC_ASSERT(heard.size() == said.size());
    for (std::size_t i = 0; i < said.size(); ++i) RC_ASSERT(arbitrary::same(heard[i], said[i]));
    RC_ASSERT(listener.proven());
  }
}

RC_GTEST_PROP(ControlChannelProperties, NothingIsUnderstoodOnceABitIsWrong, ()) {
  Ends ends;
  ends.agree();
  Bytes message = written(ends.client, golden::join());
  const auto bit = *rc::gen::inRange<std::size_t>(8 * (kControlPrefix + 1), 8 * message.size());
  message = sealing::flipped(message, bit);
  RC_ASSERT(refusal(ends.server, message) == Reject::Forged);
  RC_ASSERT(!ends.server.proven());
}

TEST(ControlChannel, BothEndsHaveTheSameKeys) {
  Ends ends;
  EXPECT_FALSE(ends.client.agreed());
  ends.agree();
  EXPECT_TRUE(ends.client.agreed() && ends.server.agreed());
  EXPECT_EQ(ends.client.keys(), ends.server.keys());
  EXPECT_FALSE(ends.client.proven() || ends.server.proven());
}

TEST(ControlChannel, WhatFollowsTheHellosCannotBeRead) {
  Ends ends;
  ends.agree();
  const Bytes sent = written(ends.client, golden::join());
  const std::string seen = sealing::textOf(sent);
  EXPECT_EQ(seen.find("left"), std::string::npos);
  EXPECT_EQ(sent[kControlPrefix], kSealedMessage);
}

TEST(ControlChannel, AHelloTellsWhetherThereIsAKey) {
  Ends ends(kNoKey, countingKey(64));
  EXPECT_FALSE(hears<Hello>(ends.server, written(ends.client, ends.client.hello())).keyed);
  EXPECT_TRUE(hears<Hello>(ends.client, written(ends.server, ends.server.hello())).keyed);
}

TEST(ControlChannel, AnotherPresharedKeyIsForgeryAndTheGoodbyeAboutItIsHeard) {
  const std::array<std::pair<Key, Key>, 3> pairs{
      {{countingKey(64), countingKey(65)}, {kNoKey, countingKey(64)}, {countingKey(64), kNoKey}}};
  for (const auto& [of_client, of_server] : pairs) {
    Ends ends(of_client, of_server);
    ends.agree();
    EXPECT_EQ(refusal(ends.server, written(ends.client, golden::join())), Reject::Forged);
    const Goodbye goodbye{"another key", GoodbyeCause::Key};
    EXPECT_EQ(hears<Goodbye>(ends.client, written(ends.server, goodbye)), goodbye);
  }
}

TEST(ControlChannel, AfterTheProofNothingInTheClearCounts) {
  for (const ControlMessage& message :
       {ControlMessage(golden::goodbye()), ControlMessage(golden::hello()), ControlMessage(golden::join())}) {
    Ends ends;
    ends.agree();
    hears<Join>(ends.server, written(ends.client, golden::join()));
    Bytes clear;
    encodeControl(message, clear);
    EXPECT_EQ(refusal(ends.server, framed(clear)), Reject::Forged);
  }
}

TEST(ControlChannel, AProvenConnectionSealsItsGoodbye) {
  Ends ends;
  ends.agree();
  hears<Join>(ends.server, written(ends.client, golden::join()));
  const Bytes sealed = written(ends.server, golden::goodbye());
  EXPECT_EQ(sealed[kControlPrefix], kSealedMessage);
  EXPECT_EQ(hears<Goodbye>(ends.client, sealed), golden::goodbye());
}

TEST(ControlChannel, AClientThatLeavesBeforeItIsAnsweredIsUnderstood) {
  Ends ends;
  ends.agree();
  hears<Join>(ends.server, written(ends.client, golden::join()));
  EXPECT_EQ(hears<Goodbye>(ends.server, written(ends.client, golden::goodbye())), golden::goodbye());
}

TEST(ControlChannel, InTheClearOnlyHellosAndGoodbyesAreHeard) {
  for (const bool agreed : {false, true}) {
    Ends ends;
    if (agreed) ends.agree();
    for (const ControlMessage& message :
         {ControlMessage(golden::join()), ControlMessage(golden::session()), ControlMessage(golden::report()),
          ControlMessage(golden::tunnelled()), ControlMessage(KeyframeRequest{})}) {
      Bytes clear;
      encodeControl(message, clear);
      EXPECT_EQ(refusal(ends.server, framed(clear)), Reject::Malformed);
    }
    Bytes clear;
    encodeControl(golden::goodbye(), clear);
    EXPECT_EQ(hears<Goodbye>(ends.server, framed(clear)), golden::goodbye());
  }
}

TEST(ControlChannel, ASecondHelloIsRefused) {
  Ends ends;
  ends.agree();
  Bytes clear;
  encodeControl(golden::hello(), clear);
  EXPECT_EQ(refusal(ends.server, framed(clear)), Reject::Malformed);
}

TEST(ControlChannel, ASealBeforeTheHellosIsRefused) {
  Ends ends;
  ends.agree();
  const Bytes sealed = written(ends.client, golden::join());
  ControlChannel fresh(Side::Server, countingKey(64), countingKey(32));
  EXPECT_EQ(refusal(fresh, sealed), Reject::Malformed);
}

TEST(ControlChannel, ARecordedStreamIsWorthNothingToANewConnection) {
  Ends first;
  const Bytes hello = written(first.client, first.client.hello());
  const Hello of_server = hears<Hello>(first.client, written(first.server, first.server.hello()));
  ASSERT_TRUE(first.server.agree(hears<Hello>(first.server, hello)));
  ASSERT_TRUE(first.client.agree(of_server));
  const Bytes join = written(first.client, golden::join());
  ASSERT_EQ(hears<Join>(first.server, join), golden::join());
  EXPECT_EQ(refusal(first.server, join), Reject::Forged) << "nor is it to the same one";

  ControlChannel second(Side::Server, countingKey(64), countingKey(33));  // another connection's secret
  const Hello replayed = hears<Hello>(second, hello);
  written(second, second.hello());
  ASSERT_TRUE(second.agree(replayed));
  EXPECT_EQ(refusal(second, join), Reject::Forged);
}

TEST(ControlChannel, WhatOneSaidDoesNotComeBackAsTheOthers) {
  Ends ends;
  ends.agree();
  const Bytes join = written(ends.client, golden::join());
  EXPECT_EQ(refusal(ends.client, join), Reject::Forged);
}

TEST(ControlChannel, AHelloChangedOnTheWayLeavesDifferentKeys) {
  Ends ends;
  // A newer minor version's field: the same Hello to who hears it, and not the same opening.
  ends.agree([](Bytes hello) {
    return framed(protobuf::withUnknownFields({hello.begin() + kControlPrefix, hello.end()}));
  });
  EXPECT_NE(ends.client.keys(), ends.server.keys());
  EXPECT_EQ(refusal(ends.server, written(ends.client, golden::join())), Reject::Forged);
}

TEST(ControlChannel, AHelloWithoutAPublicKeyIsNoneToAgreeWith) {
  Ends ends;
  Hello hello = ends.client.hello();
  hello.public_key = {};
  Bytes clear;
  encodeControl(hello, clear);
  const Hello zero = hears<Hello>(ends.server, framed(clear));
  written(ends.server, ends.server.hello());
  EXPECT_FALSE(ends.server.agree(zero));
  EXPECT_FALSE(ends.server.agreed());
}

TEST(ControlChannel, AnOlderMajorIsHeardAndItsClientCanReadTheAnswer) {
  // Both as the second version had them.
  const Bytes old_hello =
      bytesOfHex("000000230a2108021a046c6566742217636f686572656e63792072656e6465725f636c69656e74");
  const std::string_view old_refusal = "0000001522130a0f616e6f746865722076657273696f6e1001";
  Ends ends;
  const Hello hello = hears<Hello>(ends.server, old_hello);
  EXPECT_EQ(hello.major, 2U);
  EXPECT_EQ(hello.public_key, Key{});
  EXPECT_EQ(sealing::hexOf(written(ends.server, golden::refusal())), old_refusal);
}

TEST(ControlChannel, AMessageTooLongEndsTheStream) {
  Ends ends;
  ends.server.feed(bytesOfHex("00010001"));
  EXPECT_FALSE(ends.server.next().has_value());
  EXPECT_TRUE(ends.server.oversized());
}

TEST(ControlChannel, TheLargestMessagesCanBeSaid) {
  Ends ends;
  ends.agree();
  SessionConfig session = golden::session();
  session.scene.name = session.rig.name = std::string(kMaxText, 'a');
  const BasePose far{-kWorldLimitNm, -kWorldLimitNm, -kWorldLimitNm, -1};
  session.scene.start = session.scene.workplace = far;
  session.scene.robot = {far, far};
  session.scene.objects.assign(kMaxSceneObjects, {std::string(kMaxKind, 'k'), std::string(kMaxText, 'n'), far,
                                                  "#ffffff", kMaxSceneParts / int{kMaxSceneObjects}});
  ASSERT_TRUE(isValid(session));
  const Bytes welcome = written(ends.server, session);
  EXPECT_LE(welcome.size(), kControlPrefix + kMaxControlMessage);
  EXPECT_TRUE(arbitrary::same(hears<SessionConfig>(ends.client, welcome), session));
}

}  // namespace
}  // namespace coherency
