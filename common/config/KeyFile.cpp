#include "common/config/KeyFile.h"

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/config/ConfigError.h"

namespace coherency {
namespace {

using KeyBytes = std::array<std::byte, 32>;
constexpr std::string_view kPrefix = "coherency-key-1 ";
constexpr std::size_t kDigits = 2 * std::tuple_size_v<KeyBytes>;
constexpr std::size_t kFileSize = kPrefix.size() + kDigits + 1;
constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;

std::string reason() {
  return std::generic_category().message(errno);
}

/// A file's text, which is gone with it.
struct Text {
  std::array<char, kFileSize + 1> bytes{};  // one more: hex ends with a zero, and what is too long is seen
  std::size_t size = 0;
  ~Text() { sodium_memzero(bytes.data(), bytes.size()); }
};

class File {
 public:
  File(const std::string& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, kOwnerOnly)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Fills `text` with a new key's line.
void makeText(Text& text) {
  if (sodium_init() < 0) {
    throw std::runtime_error("libsodium cannot start; it needs getrandom() or a readable /dev/urandom");
  }
  KeyBytes key;
  randombytes_buf(key.data(), key.size());
  kPrefix.copy(text.bytes.data(), kPrefix.size());
  sodium_bin2hex(text.bytes.data() + kPrefix.size(), kDigits + 1,
                 reinterpret_cast<const unsigned char*>(key.data()), key.size());
  text.bytes[kFileSize - 1] = '\n';
  text.size = kFileSize;
  sodium_memzero(key.data(), key.size());
}

/// Reads to the end or until `text` is full; false with errno where it cannot be.
bool readAll(int descriptor, Text& text) {
  while (text.size < text.bytes.size()) {
    const ssize_t got = ::read(descriptor, text.bytes.data() + text.size, text.bytes.size() - text.size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return got == 0;
    text.size += static_cast<std::size_t>(got);
  }
  return true;
}

/// A file as short as this is written at once or not at all.
bool writeAll(int descriptor, const Text& text) {
  errno = EIO;
  return ::write(descriptor, text.bytes.data(), text.size) == static_cast<ssize_t>(text.size) &&
         ::fsync(descriptor) == 0;
}

}  // namespace

void makeKeyFile(const std::string& path) {
  Text text;
  makeText(text);
  const File file(path, O_WRONLY | O_CREAT | O_EXCL);
  if (file.descriptor() < 0 && errno == EEXIST) {
    throw ConfigError(
        fmt::format("{}: exists already; remove it if no machine needs its key, or name a new file", path));
  }
  if (file.descriptor() < 0) {
    throw ConfigError(fmt::format("{}: cannot be made: {}; name a file in a folder that can be written to",
                                  path, reason()));
  }
  if (writeAll(file.descriptor(), text)) return;
  const std::string why = reason();
  ::unlink(path.c_str());
  throw ConfigError(fmt::format("{}: cannot be written: {}; name a file where there is room", path, why));
}

KeyBytes readKeyFile(const std::string& path) {
  // Not blocking: a pipe without a writer is to be refused, not waited for.
  const File file(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);
  struct stat status {};
  if (file.descriptor() < 0 || ::fstat(file.descriptor(), &status) != 0) {
    throw ConfigError(fmt::format("{}: cannot be read: {}; name a key file of your own", path, reason()));
  }
  if (!S_ISREG(status.st_mode)) {
    throw ConfigError(fmt::format("{}: is no regular file; name a key file", path));
  }
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    throw ConfigError(
        fmt::format("{}: has mode {:04o}, others than its owner may have read or changed the key; "
                    "chmod 600 {}, or make a new key",
                    path, status.st_mode & 07777U, path));
  }
  Text text;
  if (!readAll(file.descriptor(), text)) {
    throw ConfigError(fmt::format("{}: cannot be read: {}; name a key file", path, reason()));
  }
  return parseKeyFile({text.bytes.data(), text.size}, path);
}

KeyBytes parseKeyFile(std::string_view text, const std::string& path) {
  const auto refuse = [&](const char* what) {
    throw ConfigError(fmt::format("{}: {}; a key file is one line, \"{}\" and {} hexadecimal digits", path,
                                  what, kPrefix, kDigits));
  };
  if (!text.starts_with(kPrefix)) refuse("is no key file of this version");
  std::string_view digits = text.substr(kPrefix.size());
  if (digits.ends_with('\n')) digits.remove_suffix(1);
  if (digits.size() != kDigits) refuse(digits.size() < kDigits ? "is too short" : "is too long");
  KeyBytes key;
  std::size_t size = 0;
  const bool whole = sodium_hex2bin(reinterpret_cast<unsigned char*>(key.data()), key.size(), digits.data(),
                                    digits.size(), nullptr, &size, nullptr) == 0;
  if (!whole || size != key.size()) {
    sodium_memzero(key.data(), key.size());
    refuse("has something other than hexadecimal digits");
  }
  if (sodium_is_zero(reinterpret_cast<const unsigned char*>(key.data()), key.size()) != 0) {
    refuse("is all zeros, which everybody knows");
  }
  return key;
}

}  // namespace coherency
