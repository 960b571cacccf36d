#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/ControlFraming.h"

namespace coherency {
namespace {

using Bytes = std::vector<std::byte>;

Bytes framed(std::span<const std::byte> message) {
  Bytes out(kControlPrefix + message.size());
  std::copy(message.begin(), message.end(), out.begin() + kControlPrefix);
  finishControlFrame(out, 0);
  return out;
}

std::vector<Bytes> drain(ControlFraming& framing) {
  std::vector<Bytes> messages;
  while (const auto message = framing.next()) messages.emplace_back(message->begin(), message->end());
  return messages;
}

TEST(ControlFraming, LengthIsBigEndian) {
  const Bytes frame = framed(Bytes(0x0102));
  EXPECT_EQ(frame[0], std::byte{0});
  EXPECT_EQ(frame[1], std::byte{0});
  EXPECT_EQ(frame[2], std::byte{1});
  EXPECT_EQ(frame[3], std::byte{2});
}

RC_GTEST_PROP(ControlFraming, AnyChoppingGivesTheSameMessages, ()) {
  const auto messages = *rc::gen::container<std::vector<std::vector<std::uint8_t>>>(
      rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>()));
  std::vector<Bytes> sent;
  Bytes stream;
  for (const auto& message : messages) {
    const auto bytes = std::as_bytes(std::span(message));
    sent.emplace_back(bytes.begin(), bytes.end());
    const Bytes frame = framed(bytes);
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  ControlFraming framing;
  std::vector<Bytes> received;
  for (std::size_t at = 0; at < stream.size();) {
    const std::size_t size = std::min(*rc::gen::inRange<std::size_t>(1, 20), stream.size() - at);
    framing.feed(std::span(stream).subspan(at, size));
    for (Bytes& message : drain(framing)) received.push_back(std::move(message));
    at += size;
  }
  RC_ASSERT(received == sent);
  RC_ASSERT(!framing.midMessage());
  RC_ASSERT(!framing.oversized());
}

TEST(ControlFraming, TheLargestPassesAndOneMoreEndsTheStream) {
  ControlFraming framing;
  framing.feed(framed(Bytes(kMaxControlMessage, std::byte{7})));
  ASSERT_EQ(drain(framing).at(0).size(), kMaxControlMessage);
  framing.feed(Bytes{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{1}});  // 65537
  EXPECT_TRUE(drain(framing).empty());
  EXPECT_TRUE(framing.oversized());
  framing.feed(framed(Bytes(3)));
  EXPECT_TRUE(drain(framing).empty());
}

TEST(ControlFraming, ALengthAloneHoldsNoMemory) {
  ControlFraming framing;
  framing.feed(Bytes(4, std::byte{0xff}));
  EXPECT_TRUE(drain(framing).empty());
  EXPECT_TRUE(framing.oversized());
}

TEST(ControlFraming, ACutMessageIsSeen) {
  const Bytes frame = framed(Bytes(10, std::byte{1}));
  for (std::size_t size = 0; size < frame.size(); ++size) {
    ControlFraming framing;
    framing.feed(std::span(frame).first(size));
    EXPECT_TRUE(drain(framing).empty()) << size;
    EXPECT_EQ(framing.midMessage(), size != 0) << size;
  }
}

}  // namespace
}  // namespace coherency
