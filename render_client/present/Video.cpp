#include "render_client/present/Video.h"

#include <array>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace coherency {
namespace {

constexpr timeval kPatience{10, 0};  // an encoder that takes nothing for so long has hung

std::string reason(int error) {
  return std::generic_category().message(error);
}

void closeOnce(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

/// Two ends of a socket that no other child of this process gets to hold. A socket, not a pipe: writing to a
/// process that is gone is then an error and no signal.
std::array<int, 2> connectedPair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error("no connection to ffmpeg can be made: " + reason(errno));
  return ends;
}

std::vector<std::string> arguments(const std::string& path, double rate, int width, int height) {
  std::ostringstream fps;
  fps.precision(9);
  fps << rate;
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  return {"ffmpeg", "-hide_banner", "-loglevel", "error", "-xerror", "-y", "-f", "rawvideo", "-pixel_format",
          "rgb24", "-video_size", size, "-framerate", fps.str(), "-i", "pipe:0",
          // H.264 as players have it needs even sides, and says how its colours were made.
          "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv", "-c:v", "libx264",
          "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p", "-colorspace", "bt709",
          "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-movflags",
          "+frag_keyframe+empty_moov+default_base_moof", "-f", "mp4", "file:" + path};
}

/// What the child has: our end as its input, a group of its own, so that Ctrl-C ends us and not it, and no
/// signal that it does not expect.
struct SpawnPlan {
  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
  SpawnPlan(int input, int error) {
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, error, STDERR_FILENO);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    sigset_t all{};
    sigset_t none{};
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setsigmask(&attributes, &none);
  }
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
};

}  // namespace

std::string ffmpegPath() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string file = (std::filesystem::path(folder) / "ffmpeg").string();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

Video::Video(std::string path, double frames_per_second)
    : path_(std::move(path)), frames_per_second_(frames_per_second) {
  if (ffmpegPath().empty())
    throw std::runtime_error(path_ +
                             ": needs the program ffmpeg, which is not installed (apt-get install ffmpeg)");
}

Video::~Video() {
  closeOnce(pictures_);
  if (process_ > 0) ::kill(process_, SIGKILL);
  wait();
  closeOnce(words_);
}

void Video::start(int width, int height) {
  width_ = width;
  height_ = height;
  auto [ours, input] = connectedPair();
  pictures_ = ours;
  ::setsockopt(pictures_, SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof(kPatience));
  int error = -1;
  try {
    const auto words = connectedPair();
    words_ = words[0];
    error = words[1];
  } catch (...) {
    closeOnce(input);
    throw;
  }
  std::vector<std::string> texts = arguments(path_, frames_per_second_, width, height);
  std::vector<char*> argv;
  argv.reserve(texts.size() + 1);
  for (std::string& text : texts) argv.push_back(text.data());
  argv.push_back(nullptr);
  const SpawnPlan plan(input, error);
  const int failure =
      ::posix_spawn(&process_, ffmpegPath().c_str(), &plan.files, &plan.attributes, argv.data(), environ);
  closeOnce(input);
  closeOnce(error);
  if (failure == 0) return;
  process_ = -1;
  throw std::runtime_error(path_ + ": ffmpeg cannot be started: " + reason(failure));
}

void Video::write(const Image& image, std::uint64_t times) {
  if (process_ < 0) start(image.width, image.height);
  if (image.width != width_ || image.height != height_)
    fail("the pictures' size has changed, and a film's cannot");
  for (; times > 0; --times)
    for (std::size_t sent = 0; sent < image.rgb.size();) {
      const ssize_t count = ::send(pictures_, image.rgb.data() + sent, image.rgb.size() - sent, MSG_NOSIGNAL);
      if (count >= 0) {
        sent += static_cast<std::size_t>(count);
      } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
        fail("ffmpeg has hung");
      } else if (errno != EINTR) {
        fail("ffmpeg has ended");
      }
    }
}

void Video::finish() {
  if (process_ < 0) return;
  closeOnce(pictures_);
  const int status = wait();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail("ffmpeg could not end it");
}

void Video::fail(const std::string& what) {
  closeOnce(pictures_);
  if (process_ > 0) ::kill(process_, SIGTERM);
  wait();
  const std::string words = lastWords();
  throw std::runtime_error(path_ + ": the film ends here: " + what + (words.empty() ? "" : ": " + words));
}

int Video::wait() {
  int status = 0;
  if (process_ > 0)
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  return status;
}

/// The last line that ffmpeg wrote. Called once it has ended, so that there is an end to it.
std::string Video::lastWords() {
  std::string all;
  std::array<char, 4096> some{};
  if (words_ >= 0)
    for (ssize_t count = 0; (count = ::recv(words_, some.data(), some.size(), MSG_DONTWAIT)) > 0;)
      all.append(some.data(), static_cast<std::size_t>(count));
  while (!all.empty() && all.back() == '\n') all.pop_back();
  return all.substr(all.rfind('\n') + 1);  // npos + 1 is the beginning
}

}  // namespace coherency
