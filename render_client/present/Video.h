#pragma once

#include <cstdint>
#include <string>

#include <sys/types.h>

#include "render_client/draw/Image.h"

namespace coherency {

/// Full path of the program ffmpeg; empty where PATH has none.
std::string ffmpegPath();

/// A film of pictures at a constant rate, encoded by the program ffmpeg (H.264, which every player knows) as
/// it is drawn. It is written in pieces, so that what there is can be played however a run ends.
class Video {
 public:
  /// Starts ffmpeg; `path` is replaced. Throws std::runtime_error where it cannot be started.
  Video(std::string path, double frames_per_second);
  /// Gives up what is not written yet.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// One frame, shown `times` long; all must be of one size. Waits for the encoder where it is slower. Throws
  /// std::runtime_error with ffmpeg's own words where it has ended or takes no more.
  void write(const Image& image, std::uint64_t times = 1);
  /// Has ffmpeg write what is left and waits for it. Throws as write() does.
  void finish();

 private:
  void start(int width, int height);
  [[noreturn]] void fail(const std::string& what);
  int wait();
  std::string lastWords();

  std::string path_;
  double frames_per_second_;
  int width_ = 0;
  int height_ = 0;
  pid_t process_ = -1;
  int pictures_ = -1;  ///< to its standard input
  int words_ = -1;     ///< from its standard error
};

}  // namespace coherency
