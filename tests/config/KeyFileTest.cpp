#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/config/ConfigError.h"
#include "common/config/KeyFile.h"

namespace coherency {
namespace {

namespace fs = std::filesystem;
using KeyBytes = std::array<std::byte, 32>;

const std::string kDigits = "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1eff";
const std::string kLine = "coherency-key-1 " + kDigits + "\n";

KeyBytes keyOfDigits() {
  KeyBytes key;
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = static_cast<std::byte>(i);
  key.back() = std::byte{0xff};
  return key;
}

template <class Do>
std::string messageOf(Do&& act) {
  try {
    act();
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "no error";
}

class KeyFileTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coherency_key_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    path_ = (folder_ / "lab.key").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& text, mode_t mode = 0600) const {
    std::ofstream(path_, std::ios::binary) << text;
    ASSERT_EQ(::chmod(path_.c_str(), mode), 0);
  }
  void expectRefused(const std::string& path, const std::string& words) const {
    const std::string message = messageOf([&] { readKeyFile(path); });
    EXPECT_EQ(message.find(path + ": "), 0U) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
  void expectContentsRefused(const std::string& text, const std::string& words) const {
    write(text);
    expectRefused(path_, words);
  }

  fs::path folder_;
  std::string path_;
};

TEST_F(KeyFileTest, WhatIsMadeIsReadAndIsAnotherEachTime) {
  makeKeyFile(path_);
  const std::string other = (folder_ / "other.key").string();
  makeKeyFile(other);
  EXPECT_NE(readKeyFile(path_), KeyBytes{});
  EXPECT_NE(readKeyFile(path_), readKeyFile(other));
}

TEST_F(KeyFileTest, IsOneLineForItsOwnerOnly) {
  const mode_t before = ::umask(0);
  makeKeyFile(path_);
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat(path_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0600U);
  std::ifstream file(path_);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(text.size(), kLine.size());
  EXPECT_EQ(text.find("coherency-key-1 "), 0U);
  EXPECT_EQ(text.find_first_not_of("0123456789abcdef", 16), text.size() - 1);
  EXPECT_EQ(text.back(), '\n');
}

TEST_F(KeyFileTest, MakingNeverReplacesAnything) {
  write("dear to somebody");
  const std::string link = (folder_ / "link.key").string();
  fs::create_symlink(folder_ / "nowhere", link);
  for (const std::string& path : {path_, link}) {
    const std::string message = messageOf([&] { makeKeyFile(path); });
    EXPECT_NE(message.find(path + ": exists already; "), std::string::npos) << message;
  }
  std::ifstream file(path_);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "dear to somebody");
  EXPECT_FALSE(fs::exists(folder_ / "nowhere"));
}

TEST_F(KeyFileTest, MakingSaysWhyItCannot) {
  const std::string path = (folder_ / "no_folder" / "lab.key").string();
  const std::string message = messageOf([&] { makeKeyFile(path); });
  EXPECT_NE(message.find(path + ": cannot be made: No such file or directory; "), std::string::npos)
      << message;
}

TEST_F(KeyFileTest, BytesStandInTheirOrder) {
  write(kLine);
  EXPECT_EQ(readKeyFile(path_), keyOfDigits());
}

TEST_F(KeyFileTest, EveryModeThatLetsOthersInIsRefused) {
  write(kLine);
  for (const mode_t bit : {0040U, 0020U, 0010U, 0004U, 0002U, 0001U}) {
    ASSERT_EQ(::chmod(path_.c_str(), 0600 | bit), 0);
    expectRefused(path_, "chmod 600 " + path_);
  }
  ASSERT_EQ(::chmod(path_.c_str(), 0644), 0);
  expectRefused(path_, "has mode 0644");
  ASSERT_EQ(::chmod(path_.c_str(), 0400), 0);
  EXPECT_EQ(readKeyFile(path_), keyOfDigits());
}

TEST_F(KeyFileTest, ALinkCountsByWhatItLeadsTo) {
  write(kLine);
  const std::string link = (folder_ / "link.key").string();
  fs::create_symlink(path_, link);
  EXPECT_EQ(readKeyFile(link), keyOfDigits());
  ASSERT_EQ(::chmod(path_.c_str(), 0640), 0);
  expectRefused(link, "has mode 0640");
}

TEST_F(KeyFileTest, WhatIsNoRegularFileIsRefusedAndNotWaitedFor) {
  expectRefused((folder_ / "missing.key").string(), "cannot be read: No such file or directory");
  expectRefused(folder_.string(), "is no regular file");
  expectRefused("/dev/null", "is no regular file");
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  expectRefused(path_, "is no regular file");
}

TEST_F(KeyFileTest, WhatMayNotBeReadIsRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  write(kLine, 0000);
  expectRefused(path_, "cannot be read: Permission denied");
}

TEST_F(KeyFileTest, ContentsThatAreNoKeyAreRefused) {
  expectContentsRefused("", "is no key file");
  expectContentsRefused("coherency-key-2 " + kDigits + "\n", "is no key file of this version");
  expectContentsRefused(" " + kLine, "is no key file");
  expectContentsRefused("coherency-key-1\t" + kDigits, "is no key file");
  expectContentsRefused("coherency-key-1 ", "is too short");
  expectContentsRefused("coherency-key-1 " + kDigits.substr(1), "is too short");
  expectContentsRefused("coherency-key-1 " + kDigits + "0", "is too long");
  expectContentsRefused(kLine + "\n", "is too long");
  expectContentsRefused(kLine + std::string(100'000, '0'), "is too long");
  expectContentsRefused("coherency-key-1 " + kDigits + "\r\n", "is too long");
  expectContentsRefused("coherency-key-1 " + std::string(64, '0') + "\n", "is all zeros");
}

TEST_F(KeyFileTest, ADigitThatIsNoneIsRefusedAtEveryPlace) {
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    for (const char bad : {'g', ' ', '\n', '\0', ':', '\xe9'}) {
      std::string digits = kDigits;
      digits[i] = bad;
      const std::string message =
          messageOf([&] { parseKeyFile("coherency-key-1 " + digits + "\n", "it.key"); });
      EXPECT_NE(message.find("it.key: "), std::string::npos) << i;
      EXPECT_NE(message.find("other than hexadecimal"), std::string::npos) << i << ": " << message;
    }
  }
}

TEST_F(KeyFileTest, TheEndOfLineAndTheCaseOfDigitsDoNotMatter) {
  std::string upper = kDigits;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  EXPECT_EQ(parseKeyFile("coherency-key-1 " + kDigits, "it.key"), keyOfDigits());
  EXPECT_EQ(parseKeyFile("coherency-key-1 " + upper + "\n", "it.key"), keyOfDigits());
}

TEST_F(KeyFileTest, NoErrorQuotesTheContents) {
  const std::string secret = "5ec2e75ec2e75ec2e75ec2e7";
  for (const std::string& text : {secret, "coherency-key-1 " + secret, "coherency-key-1 " + secret + kDigits,
                                  "coherency-key-1 " + secret + std::string(40, 'z'),
                                  "coherency-key-0 " + secret + std::string(40, '0')}) {
    write(text);
    const std::string message = messageOf([&] { readKeyFile(path_); });
    EXPECT_NE(message, "no error");
    EXPECT_EQ(message.find("5ec2"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace coherency
