#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "common/config/KeyFile.h"
#include "motion_server/Options.h"

namespace coherency {
namespace {

namespace fs = std::filesystem;

class ServerOptionsTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coherency_options_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// `said_`: what was said on stderr.
  ServerOptions parse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "motion_server");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    testing::internal::CaptureStderr();
    exit_code_ = -1;
    ServerOptions options = parseServerOptions(static_cast<int>(argv.size()), argv.data(), exit_code_);
    said_ = testing::internal::GetCapturedStderr();
    return options;
  }
  ServerOptions parseListening(const std::string& where, std::vector<std::string> more) {
    more.insert(more.end(),
                {"--config", std::string(COHERENCY_CONFIGS) + "/servers/laboratory.toml", "--listen", where});
    return parse(more);
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void expectRefused(const std::string& words) {
    EXPECT_EQ(exit_code_, 2);
    EXPECT_NE(said_.find(words), std::string::npos) << said_;
  }

  fs::path folder_;
  int exit_code_ = -1;
  std::string said_;
};

TEST_F(ServerOptionsTest, OnLoopbackNoKeyIsNeeded) {
  for (const char* where : {"127.0.0.1:0", "127.1.2.3:0", "[::1]:0"}) {
    EXPECT_EQ(parseListening(where, {}).key, kNoKey);
    EXPECT_EQ(exit_code_, -1) << where << ": " << said_;
  }
}

TEST_F(ServerOptionsTest, OnANetworkAKeyIsNeededOrTheWordInsecure) {
  for (const char* where : {"0.0.0.0:0", "192.0.2.1:0", "[::]:0"}) {
    parseListening(where, {});
    expectRefused("--make-key FILE");
    expectRefused("--insecure");
    EXPECT_EQ(parseListening(where, {"--insecure"}).key, kNoKey);
    EXPECT_EQ(exit_code_, -1) << said_;
  }
  makeKeyFile(file("key"));
  EXPECT_EQ(parseListening("0.0.0.0:0", {"--key", file("key")}).key, readKeyFile(file("key")));
  EXPECT_EQ(exit_code_, -1) << said_;
}

TEST_F(ServerOptionsTest, AKeyThatCannotBeHadIsNamed) {
  parseListening("127.0.0.1:0", {"--key", file("absent")});
  expectRefused(file("absent"));
  std::ofstream(file("noise")) << "coherency\n";
  fs::permissions(file("noise"), fs::perms::owner_read);
  parseListening("0.0.0.0:0", {"--key", file("noise")});
  expectRefused("is no key file");
  makeKeyFile(file("open"));
  fs::permissions(file("open"), fs::perms::owner_read | fs::perms::others_read);
  parseListening("0.0.0.0:0", {"--key", file("open")});
  expectRefused("chmod 600");
}

TEST_F(ServerOptionsTest, ToMakeAKeyNeedsNothingElse) {
  EXPECT_EQ(parse({"--make-key", file("new")}).make_key, file("new"));
  EXPECT_EQ(exit_code_, -1) << said_;
  EXPECT_FALSE(fs::exists(file("new"))) << "it is not made by reading options";
  parse({"--make-key"});
  expectRefused("--make-key");
}

}  // namespace
}  // namespace coherency
