// Pictures to files and back; files are never trusted. Needs no OpenGL.

#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "render_client/present/Png.h"

namespace coherency {
namespace {

namespace fs = std::filesystem;

Image rainbow(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height * 3; ++i)
    image.rgb.push_back(static_cast<std::uint8_t>(i * 37 + i / 256));
  return image;
}

class Png : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name) const { return folder_ / name; }
  fs::path written(const std::string& name, const std::string& bytes) const {
    std::ofstream(file(name), std::ios::binary) << bytes;
    return file(name);
  }
  static std::string bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) / ("coherency_png_" + std::to_string(::getpid()));
};

/// Expects a complaint that names the file.
template <class Act>
void expectRefused(const fs::path& path, Act&& act, const std::string& why = "") {
  try {
    act();
    ADD_FAILURE() << path << " was accepted";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find(path.string() + ": cannot be "), 0U) << text;
    EXPECT_NE(text.find(why), std::string::npos) << text;
  }
}
void expectUnreadable(const fs::path& path, const std::string& why = "") {
  expectRefused(
      path, [&] { readPng(path); }, why);
}

TEST_F(Png, GoesThereAndBackWithItsText) {
  const PngText text = {
      {"tick", "12345"}, {"dof_units", "1 -2 3"}, {"empty", ""}, {"long", std::string(5000, 'x')}};
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {64, 3}}) {
    const Image image = rainbow(width, height);
    writePng(file("a.png"), image, text);
    PngText read_text;
    const Image read = readPng(file("a.png"), &read_text);
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(read.height, height);
    EXPECT_EQ(read.rgb, image.rgb);
    EXPECT_EQ(read_text, text);
  }
}

TEST_F(Png, ReadsOtherKindsAsEightBitColour) {
  // 2 x 1, 16-bit grey with transparency: white a quarter opaque, 0x8080 opaque.
  const unsigned char grey[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49,
                                0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x10, 0x04,
                                0x00, 0x00, 0x00, 0x0e, 0xbb, 0x6b, 0x42, 0x00, 0x00, 0x00, 0x11, 0x49, 0x44,
                                0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xff, 0xdf, 0xc1, 0xa1, 0xa1, 0xe1, 0xff,
                                0x7f, 0x00, 0x18, 0x37, 0x05, 0x7d, 0x9c, 0xd7, 0x2a, 0x38, 0x00, 0x00, 0x00,
                                0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const std::string text(reinterpret_cast<const char*>(grey), sizeof(grey));
  const Image read = readPng(written("grey.png", text));
  EXPECT_EQ(read.width, 2);
  EXPECT_EQ(read.rgb, (std::vector<std::uint8_t>{255, 255, 255, 128, 128, 128}));
}

TEST_F(Png, RefusesWhatIsNoPicture) {
  expectUnreadable(file("absent.png"), "No such file");
  expectUnreadable(written("empty.png", ""));
  expectUnreadable(written("text.png", "this is no picture, though it is long enough to look at"));
  fs::create_directory(file("folder.png"));
  expectUnreadable(file("folder.png"));
}

TEST_F(Png, RefusesASizeThatWouldTakeAllMemory) {
  std::string huge("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x80\0\0\0\x80\0\x08\x02\0\0\0", 29);
  huge += std::string("\x4b\x1e\x34\x28", 4);                 // the header's checksum
  huge += std::string("\0\0\0\1IDAT\0\x28\x38\x7d\xe8", 13);  // as many pixels as fit into a byte
  expectUnreadable(written("huge.png", huge), "1073741824 pixels");
}

TEST_F(Png, RefusesEveryFileCutShort) {
  writePng(file("whole.png"), rainbow(8, 4), {{"scene", "test"}});
  const std::string whole = bytes(file("whole.png"));
  // libpng reads the end chunk's head before it knows that this is all; what is missing of its checksum must
  // be noticed.
  for (std::size_t length = 0; length < whole.size(); ++length)
    expectUnreadable(written("cut.png", whole.substr(0, length)));
}

TEST_F(Png, NoDamagedByteDoesHarm) {
  const Image image = rainbow(8, 4);
  writePng(file("whole.png"), image, {{"scene", "test"}});
  const std::string whole = bytes(file("whole.png"));
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const int flip : {0x01, 0x80, 0xFF}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      try {
        const Image read = readPng(written("damaged.png", damaged));
        // Only what is not needed for the pixels may be damaged without notice.
        EXPECT_EQ(read.rgb, image.rgb) << "byte " << at << " ^ " << flip;
      } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("damaged.png: cannot be read: "), std::string::npos);
      }
    }
}

TEST_F(Png, RefusesToWriteWhatIsNoPicture) {
  const fs::path path = file("bad.png");
  Image short_of_bytes = rainbow(4, 4);
  short_of_bytes.rgb.pop_back();
  expectRefused(
      path, [&] { writePng(path, short_of_bytes); }, "do not agree");
  expectRefused(
      path, [&] { writePng(path, Image{}); }, "do not agree");
  for (const std::string& keyword : {std::string(), std::string(80, 'k')})
    expectRefused(
        path,
        [&] {
          writePng(path, rainbow(4, 4), {{keyword, "text"}});
        },
        "1 to 79 characters");
  EXPECT_FALSE(fs::exists(path)) << "nothing half-written is left";
}

TEST_F(Png, SaysWhereItCannotWrite) {
  const fs::path nowhere = file("no/such/folder.png");
  expectRefused(
      nowhere, [&] { writePng(nowhere, rainbow(2, 2)); }, "No such file");
  if (fs::exists("/dev/full")) expectRefused("/dev/full", [] { writePng("/dev/full", rainbow(64, 64)); });
  EXPECT_TRUE(!fs::exists("/proc/self") || fs::exists("/dev/full")) << "a device is no file to remove";
}

}  // namespace
}  // namespace coherency
