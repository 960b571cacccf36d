#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/Validity.h"
#include "tests/wire/Generators.h"

namespace coherency {
namespace {

using Bytes = std::vector<std::byte>;

/// The message without its length.
template <class T>
Bytes body(const T& value) {
  const Bytes frame = encodeControl(value);
  return {frame.begin() + kControlPrefix, frame.end()};
}

bool isRejectedOrValid(const DecodedControl& decoded) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Reject>) {
          return true;
        } else {
          return isValid(value);
        }
      },
      decoded);
}

RC_GTEST_PROP(ControlCodec, EverythingComesBackAsItWas, ()) {
  const Hello hello = arbitrary::hello();
  const SessionConfig session = arbitrary::session();
  const ClientReport report = arbitrary::report();
  const Goodbye goodbye = arbitrary::goodbye();
  const ModeRequest request = arbitrary::modeRequest();
  RC_ASSERT(std::get<ModeRequest>(decodeControl(body(request))) == request);
  RC_ASSERT(std::get<Hello>(decodeControl(body(hello))) == hello);
  RC_ASSERT(arbitrary::same(std::get<SessionConfig>(decodeControl(body(session))), session));
  RC_ASSERT(std::get<ClientReport>(decodeControl(body(report))) == report);
  RC_ASSERT(std::get<Goodbye>(decodeControl(body(goodbye))) == goodbye);
}

TEST(ControlCodec, TheLargestReportFitsAMessage) {
  ClientReport report;
  report.frames.assign(kMaxReportFrames, FrameReport{~std::uint64_t{0}, ~std::uint64_t{0}, kMaxTimeNs});
  EXPECT_LE(body(report).size(), kMaxControlMessage);
  EXPECT_EQ(std::get<ClientReport>(decodeControl(body(report))), report);
}

RC_GTEST_PROP(ControlCodec, DamageNeverYieldsWhatCannotBe, ()) {
  const std::array<Bytes, 5> messages{body(arbitrary::hello()), body(arbitrary::session()),
                                      body(arbitrary::report()), body(arbitrary::goodbye()),
                                      body(arbitrary::modeRequest())};
  for (const Bytes& good : messages) {
    for (std::size_t i = 0; i < good.size(); ++i) {
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

TEST(ControlCodec, AnotherMajorVersionIsToldApart) {
  Hello hello{kWireMajor + 1, 7, "anything", "\x01"};
  const auto decoded = std::get<Hello>(decodeControl(body(hello)));
  EXPECT_EQ(decoded.major, kWireMajor + 1);
  EXPECT_EQ(decoded.minor, 7U);
  // A Welcome of the next version, by hand: field 2 of the message, of which field 1 is its number.
  const Bytes welcome{std::byte{0x12}, std::byte{0x02}, std::byte{0x08}, std::byte{kWireMajor + 1}};
  EXPECT_EQ(std::get<Reject>(decodeControl(welcome)), Reject::Version);
}

TEST(ControlCodec, UnknownFieldsOfANewerMinorAreIgnored) {
  Bytes message = body(Hello{kWireMajor, kWireMinor, "left", "test"});
  for (const int b : {0x98, 0x06, 0x05}) message.push_back(static_cast<std::byte>(b));  // field 99 = 5
  EXPECT_EQ(std::get<Hello>(decodeControl(message)).eye, "left");
}

TEST(ControlCodec, AWelcomeWithAMeasureMissingOrTwiceIsRefused) {
  rc::check("one measure too few or too many", [] {
    const Bytes good = body(arbitrary::session());
    // The measures are field 8 of field 2: take the message apart at its first, and leave it out or repeat
    // it.
    const std::string name(rigFields().front().name);
    const std::string text(reinterpret_cast<const char*>(good.data()), good.size());
    const std::size_t at = text.find("\x42", text.find(name) - 4);
    const std::size_t length = static_cast<unsigned char>(text[at + 1]) + 2U;
    const std::size_t header = static_cast<unsigned char>(text[1]) >= 0x80 ? 3 : 2;
    const std::string inner = text.substr(header);
    const auto wrapped = [&](const std::string& content) {
      std::string out = "\x12";
      out.push_back(static_cast<char>((content.size() & 0x7f) | 0x80));
      out.push_back(static_cast<char>(content.size() >> 7));
      return out + content;
    };
    const std::string measure = text.substr(at, length);
    const std::string fewer = wrapped(inner.substr(0, at - header) + inner.substr(at - header + length));
    const std::string more = wrapped(inner + measure);
    const std::string equal = wrapped(inner);
    RC_ASSERT(std::holds_alternative<SessionConfig>(decodeControl(std::as_bytes(std::span(equal)))));
    RC_ASSERT(std::holds_alternative<Reject>(decodeControl(std::as_bytes(std::span(fewer)))));
    RC_ASSERT(std::holds_alternative<Reject>(decodeControl(std::as_bytes(std::span(more)))));
  });
}

}  // namespace
}  // namespace coherency
