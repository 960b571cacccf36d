// Films: as many frames as were written, of their size and rate, and a clear word where one cannot go on.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "render_client/present/Video.h"

namespace coherency {
namespace {

namespace fs = std::filesystem;

Image grey(int width, int height, int level) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(width * height) * 3,
                                    static_cast<std::uint8_t>(level))};
}

std::string output(const std::string& command) {
  std::string all;
  std::array<char, 256> some{};
  std::FILE* pipe = popen(command.c_str(), "r");
  while (std::fgets(some.data(), some.size(), pipe) != nullptr) all += some.data();
  pclose(pipe);
  return all;
}

std::string messageOf(const auto& action) {
  try {
    action();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "no error";
}

class VideoTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
    path_ = std::getenv("PATH");
  }
  void TearDown() override {
    setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// Has `script` stand for ffmpeg.
  void pretend(const std::string& script) const {
    std::ofstream(folder_ / "ffmpeg") << "#!/bin/sh\n" << script << "\n";
    fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
    setenv("PATH", (folder_.string() + ":" + path_).c_str(), 1);
  }

  fs::path folder_;
  std::string path_;
};

class RealVideo : public VideoTest {
 protected:
  void SetUp() override {
    VideoTest::SetUp();
    if (ffmpegPath().empty()) GTEST_SKIP() << "ffmpeg is not installed";
  }
  std::string probe(const std::string& name) const {
    return output(
        "ffprobe -v error -count_frames -show_entries stream=width,height,nb_read_frames,avg_frame_rate "
        "-of csv=p=0 '" +
        file(name) + "'");
  }
};

TEST_F(RealVideo, HasTheFramesThatWereWritten) {
  Video video(file("a b:c%d.mp4"), 62.5);
  for (int i = 0; i < 20; ++i) video.write(grey(64, 48, 10 * i), i == 3 ? 4 : 1);
  video.finish();
  EXPECT_EQ(probe("a b:c%d.mp4"), "64,48,125/2,23\n");
}

TEST_F(RealVideo, OddSidesArePadded) {
  Video video(file("a.mp4"), 30.0);
  for (int i = 0; i < 5; ++i) video.write(grey(65, 49, 100));
  video.finish();
  EXPECT_EQ(probe("a.mp4"), "66,50,30/1,5\n");
}

TEST_F(RealVideo, APlaceThatCannotBeWrittenToIsNamedInFfmpegsWords) {
  Video video(file("nowhere/a.mp4"), 30.0);
  const std::string message = messageOf([&] {
    for (int i = 0; i < 5; ++i) video.write(grey(640, 480, 100));
    video.finish();
  });
  EXPECT_NE(message.find("nowhere/a.mp4: the film ends here: ffmpeg"), std::string::npos) << message;
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
}

TEST_F(RealVideo, PicturesOfAnotherSizeEndItAndWhatThereIsCanBePlayed) {
  Video video(file("a.mp4"), 10.0);
  for (int i = 0; i < 400; ++i) video.write(grey(64, 48, i % 200));
  EXPECT_NE(messageOf([&] { video.write(grey(32, 48, 0)); }).find("size has changed"), std::string::npos);
  EXPECT_TRUE(probe("a.mp4").starts_with("64,48,10/1,"));
}

TEST_F(VideoTest, AnEncoderThatDiesIsAnErrorAndNoSignal) {
  pretend("head -c 100000 >/dev/null; echo 'first words' >&2; echo 'there is no room' >&2; exit 1");
  Video video(file("a.mp4"), 30.0);
  const std::string message = messageOf([&] {
    for (int i = 0; i < 100; ++i) video.write(grey(640, 480, 0));
  });
  EXPECT_EQ(message, file("a.mp4") + ": the film ends here: ffmpeg has ended: there is no room");
}

TEST_F(VideoTest, AnEncoderThatCannotEndItsFileIsAnError) {
  pretend("cat >/dev/null; echo 'no trailer' >&2; exit 3");
  Video video(file("a.mp4"), 30.0);
  video.write(grey(64, 48, 0));
  EXPECT_NE(messageOf([&] { video.finish(); }).find("ffmpeg could not end it: no trailer"),
            std::string::npos);
}

TEST_F(VideoTest, NothingIsStartedThatIsNotThere) {
  setenv("PATH", folder_.c_str(), 1);
  EXPECT_EQ(ffmpegPath(), "");
  EXPECT_NE(messageOf([&] { Video(file("a.mp4"), 30.0); }).find("apt-get install ffmpeg"), std::string::npos);
  std::ofstream(folder_ / "ffmpeg") << "not executable\n";
  EXPECT_EQ(ffmpegPath(), "");
}

TEST_F(VideoTest, AFilmWithoutPicturesIsNone) {
  Video video(file("a.mp4"), 30.0);
  video.finish();
  EXPECT_FALSE(fs::exists(file("a.mp4")));
}

}  // namespace
}  // namespace coherency
