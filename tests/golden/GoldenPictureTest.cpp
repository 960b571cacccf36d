// That golden pictures tell what differs, and only that; needs no OpenGL.

#include <gtest/gtest.h>

#include "common/scene/Primitives.h"
#include "tests/golden/GoldenPicture.h"
#include "tests/golden/PinnedRenderer.h"

namespace coherency::golden {
namespace {

constexpr int kWidth = 50;
constexpr int kHeight = 20;  // a thousand pixels: two may differ

/// Two boxes of one name and one of another, side by side, with nothing beside them.
class Pictures : public testing::Test {
 protected:
  Pictures() {
    for (Box* box : {&left_, &middle_, &right_}) root_.addMember(box);
    for (int i = 0; i < kWidth * kHeight; ++i) {
      ids_.ids.push_back(static_cast<std::uint32_t>(i % kWidth * 4 / kWidth));
      colour_.rgb.insert(colour_.rgb.end(), {100, 150, 200});
    }
  }
  GoldenPicture picture() const { return goldenPicture(colour_, ids_, root_); }

  VRObject root_{"root"};
  Box left_{{1.0, 1.0, 1.0}, "box"};
  Box middle_{{1.0, 1.0, 1.0}, "box"};
  Box right_{{1.0, 1.0, 1.0}, "other"};
  Image colour_{kWidth, kHeight, {}};
  IdImage ids_{kWidth, kHeight, {}, {&left_, &middle_, &right_}};
};

TEST_F(Pictures, AreTheSameAfterWritingAndReading) {
  const std::filesystem::path folder = testing::TempDir();
  write(picture(), folder, "round_trip");
  const GoldenPicture again = read(folder, "round_trip");
  EXPECT_EQ(again.colour.rgb, colour_.rgb);
  EXPECT_EQ(again.objects, (std::vector<std::string>{"root/box", "root/box #2", "root/other"}));
  const Difference found = difference(again, picture());
  EXPECT_TRUE(found.matches()) << found.text();
  EXPECT_EQ(found.most, 0);
  std::filesystem::remove(folder / "round_trip_ids.txt");
  EXPECT_THROW(read(folder, "round_trip"), std::runtime_error);
}

TEST_F(Pictures, OfWhichOnePixelShowsAnotherObjectDoNotMatch) {
  const GoldenPicture expected = picture();
  ids_.ids.back() = 1;
  const Difference found = difference(picture(), expected);
  EXPECT_FALSE(found.matches());
  EXPECT_EQ(found.ids, 1U);
  EXPECT_EQ(found.first_id, "root/box in place of root/other");
}

TEST_F(Pictures, MatchWhateverNumbersTheirObjectsHave) {
  const GoldenPicture expected = picture();
  ids_.objects = {&right_, &left_, &middle_};
  for (std::uint32_t& id : ids_.ids) id = id == 0 ? 0 : id % 3 + 1;
  EXPECT_TRUE(difference(picture(), expected).matches());
  ids_.objects = {&left_, &right_, &middle_};
  EXPECT_FALSE(difference(picture(), expected).matches());
}

TEST_F(Pictures, MayDifferALittleInAllColoursAndMuchInVeryFew) {
  const GoldenPicture expected = picture();
  for (std::uint8_t& c : colour_.rgb) c = static_cast<std::uint8_t>(c + Difference::kTolerance);
  EXPECT_TRUE(difference(picture(), expected).matches());
  colour_.rgb[0] = colour_.rgb[3] = 0;
  EXPECT_TRUE(difference(picture(), expected).matches()) << "two in a thousand";
  colour_.rgb[7] = static_cast<std::uint8_t>(expected.colour.rgb[7] + Difference::kTolerance + 1);
  const Difference found = difference(picture(), expected);
  EXPECT_FALSE(found.matches()) << "three in a thousand";
  EXPECT_EQ(found.ids, 0U);
  EXPECT_EQ(found.most, 100);
}

TEST_F(Pictures, OfAnotherSizeDoNotMatch) {
  const GoldenPicture expected = picture();
  GoldenPicture narrow = expected;
  std::swap(narrow.colour.width, narrow.colour.height);
  EXPECT_FALSE(difference(narrow, expected).matches());
}

TEST(PinnedRenderer, IsHeldAgainstItsLikeOnly) {
  const GlName pinned{"llvmpipe (LLVM 15.0.6, 128 bits)", "4.5 (Core Profile) Mesa 22.3.6"};
  EXPECT_TRUE(comparable(pinned, pinned));
  EXPECT_TRUE(comparable({"llvmpipe (LLVM 17.0.6, 128 bits)", "4.5 (Core Profile) Mesa 24.0.9"}, pinned));
  EXPECT_FALSE(comparable({"llvmpipe (LLVM 15.0.6, 256 bits)", pinned.version}, pinned));
  EXPECT_FALSE(comparable({"softpipe", pinned.version}, pinned));
  EXPECT_FALSE(comparable({"NVIDIA H100/PCIe/SSE2", "4.6.0 NVIDIA 550.54"}, pinned));
  EXPECT_TRUE(comparable(pinnedRenderer(), pinnedRenderer()));
}

}  // namespace
}  // namespace coherency::golden
