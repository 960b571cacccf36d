#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/ControlFraming.h"
#include "common/wire/SealedStream.h"
#include "tests/wire/SealSupport.h"

namespace coherency {
namespace {

using namespace sealing;

Bytes sealed(StreamSealer& sealer, std::span<const std::byte> body) {
  Bytes message(1);
  message.insert(message.end(), body.begin(), body.end());
  sealer.seal(message, 0);
  return message;
}

/// Of a copy, as a message may be opened again.
std::optional<Bytes> opened(StreamOpener& opener, Bytes message) {
  const auto body = opener.open(message);
  if (!body) return std::nullopt;
  return copyOf(*body);
}

class SealedStream : public testing::Test {
 protected:
  Bytes sealNext(std::string_view text) { return sealed(sealer_, bytesOf(text)); }
  void expectOpens(const Bytes& message, std::string_view text) {
    const auto body = opened(opener_, message);
    ASSERT_TRUE(body.has_value());
    EXPECT_EQ(textOf(*body), text);
  }
  void expectRefused(const Bytes& message) { EXPECT_FALSE(opened(opener_, message).has_value()); }

  StreamSealer sealer_{countingKey(0)};
  StreamOpener opener_{countingKey(0)};
};

TEST_F(SealedStream, IsTheBytesThatAnotherImplementationMakes) {
  // tests/wire/seal_reference.py
  EXPECT_EQ(hexOf(sealNext("coherency")), "017bd72a54df83c8b26a52bc5f772f6563756449130e81b573f7");
  EXPECT_EQ(hexOf(sealNext("coherency")), "010a3314bc436fd619542cde18f924516da80008d0ef2d646f2e");
}

RC_GTEST_PROP(SealedStreamProperties, AnyMessagesComeBackThroughTheFraming, ()) {
  const Key key = arbitraryKey();
  StreamSealer sealer(key);
  StreamOpener opener(key);
  ControlFraming framing;
  std::vector<Bytes> sent;
  Bytes stream;
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
    sent.push_back(arbitraryBytes(2000));
    const std::size_t start = stream.size();
    stream.resize(start + kControlPrefix + 1);
    stream.insert(stream.end(), sent.back().begin(), sent.back().end());
    sealer.seal(stream, start + kControlPrefix);
    finishControlFrame(stream, start);
  }
  framing.feed(stream);
  for (const Bytes& body : sent) RC_ASSERT(opened(opener, copyOf(framing.next().value())) == body);
  RC_ASSERT(!framing.next().has_value());
}

TEST_F(SealedStream, OpensInOrderOnly) {
  const std::array<Bytes, 3> sent{sealNext("one"), sealNext("two"), sealNext("three")};
  expectRefused(sent[1]);
  expectRefused(sent[2]);
  expectOpens(sent[0], "one");
  expectRefused(sent[0]);
  expectRefused(sent[2]);
  expectOpens(sent[1], "two");
  expectRefused(sent[0]);
  expectOpens(sent[2], "three");
}

TEST_F(SealedStream, EveryFlippedBitIsFound) {
  const Bytes good = sealNext("a message longer than one block of the cipher, which has sixty-four bytes");
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    SCOPED_TRACE(bit);
    expectRefused(flipped(good, bit));
  }
  expectOpens(good, "a message longer than one block of the cipher, which has sixty-four bytes");
}

TEST_F(SealedStream, EveryLengthButItsOwnIsRefused) {
  const Bytes good = sealNext("a message");
  for (std::size_t size = 0; size < good.size() + 40; ++size) {
    if (size == good.size()) continue;
    SCOPED_TRACE(size);
    Bytes other = good;
    other.resize(size);
    expectRefused(other);
  }
  expectOpens(good, "a message");
}

TEST_F(SealedStream, WhatIsInTheClearIsNotSealed) {
  const Bytes good = sealNext("a message");
  Bytes clear = good;
  clear.front() = std::byte{0x0a};  // as a hello begins
  expectRefused(clear);
  // Nor does a tag make it so.
  for (const std::byte kind : {std::byte{0}, std::byte{2}}) {
    Bytes tagged(1 + kSealTag);
    tagged.front() = kind;
    const auto whole = std::span(tagged);
    encrypt(countingKey(0), nonceOf(0, 0), whole.first(1), whole.subspan(1, 0), whole.last<kSealTag>());
    expectRefused(tagged);
  }
  expectOpens(good, "a message");
}

TEST_F(SealedStream, AnotherKeyIsForged) {
  StreamSealer other(countingKey(1));
  expectRefused(sealed(other, bytesOf("a message")));
  expectOpens(sealNext(""), "");
}

}  // namespace
}  // namespace coherency
