#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "common/config/ConfigError.h"
#include "common/config/Endpoint.h"
#include "common/config/HmdProfile.h"
#include "common/config/ReplaceFile.h"
#include "common/config/RigFile.h"
#include "common/config/SceneFile.h"
#include "common/config/ServerConfig.h"
#include "common/world/Catalogue.h"

namespace coherency {
namespace {

namespace fs = std::filesystem;

class ConfigTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coherency_") + test->name());
    fs::create_directories(folder_ / "servers");
    fs::create_directories(folder_ / "scenes");
    std::ofstream(folder_ / "scenes/laboratory.toml") << "# empty\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& text, const std::string& name = "servers/it.toml") {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  template <class Read>
  static std::string messageOf(Read&& read) {
    try {
      read();
    } catch (const ConfigError& e) {
      return e.what();
    }
    return "no error";
  }

  void expectRefused(const std::string& text, const std::string& place, const std::string& words) {
    const std::string message = messageOf([&] { readServerConfig(write(text)); });
    EXPECT_NE(message.find("it.toml" + place), std::string::npos) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }

  fs::path folder_;
};

TEST_F(ConfigTest, EveryShippedFileLoads) {
  const fs::path configs = COHERENCY_CONFIGS;
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(configs)) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    const std::string folder = entry.path().parent_path().filename();
    const std::string path = entry.path().string();
    if (folder == "servers")
      EXPECT_NO_THROW(readServerConfig(path)) << path;
    else if (folder == "rigs")
      EXPECT_NO_THROW(readRig(path)) << path;
    else if (folder == "hmds")
      EXPECT_NO_THROW(readHmdProfile(path)) << path;
    else if (folder == "scenes")
      EXPECT_NO_THROW(readScene(entry.path().stem().string() + (entry.path().stem() == "grid" ? ":100" : ""),
                                entry.path().parent_path().string()))
          << path;
    else
      ADD_FAILURE() << path << ": nobody reads this folder";
  }
  EXPECT_GE(files, 8);
}

TEST_F(ConfigTest, ShippedDefaultsAreTheProgramsDefaults) {
  const fs::path configs = COHERENCY_CONFIGS;
  const HmdProfile file = readHmdProfile((configs / "hmds/generic.toml").string());
  const HmdProfile built_in;
  EXPECT_EQ(file.name, built_in.name);
  EXPECT_EQ(file.source, built_in.source);
  EXPECT_EQ(file.near_m, built_in.near_m);
  for (const auto& [a, b] :
       {std::pair{file.left.view, built_in.left.view}, std::pair{file.right.view, built_in.right.view}}) {
    EXPECT_EQ(a.tan_left, b.tan_left);
    EXPECT_EQ(a.tan_right, b.tan_right);
    EXPECT_EQ(a.tan_down, b.tan_down);
    EXPECT_EQ(a.tan_up, b.tan_up);
  }
  const Rig rig = readRig((configs / "rigs/default.toml").string());
  for (const RigField& field : rigFields()) EXPECT_EQ(rig.*field.value, Rig{}.*field.value) << field.name;
  const ServerConfig server = readServerConfig((configs / "servers/laboratory.toml").string());
  EXPECT_EQ(server.address, ServerConfig{}.address);
  EXPECT_EQ(server.port, ServerConfig{}.port);
  EXPECT_EQ(server.rate_hz, ServerConfig{}.rate_hz);
  EXPECT_EQ(server.master, ServerConfig{}.master);
  EXPECT_EQ(server.encoding, ServerConfig{}.encoding);
  EXPECT_EQ(server.multicast_address, ServerConfig{}.multicast_address);
  EXPECT_EQ(server.discovery, ServerConfig{}.discovery);
  EXPECT_EQ(server.frames_hz, ServerConfig{}.frames_hz);
  EXPECT_EQ(server.least_margin_ms, ServerConfig{}.least_margin_ms);
  EXPECT_EQ(server.most_margin_ms, ServerConfig{}.most_margin_ms);
  EXPECT_EQ(server.prediction, ServerConfig{}.prediction);
  EXPECT_EQ(server.horizon_ms, ServerConfig{}.horizon_ms);
}

TEST_F(ConfigTest, WrongFilesAreRefusedWithPlaceAndRemedy) {
  expectRefused("scene = \n", ":1:", "");
  expectRefused("[network]\nport = 70000\n",
                ":2:", "network.port: 70000 is out of range; must be from 0 to 65535");
  expectRefused("[network]\nport = \"x\"\n", ":2:", "must be a whole number");
  expectRefused("[sampling]\nrate_hz = nan\n", ":2:", "sampling.rate_hz");
  expectRefused("[sampling]\n\n  rate_hz = inf\n", ":3:", "must be from 10 to 10000");
  expectRefused("[master]\nkind = \"telepathy\"\n", ":2:", "must be one of: simulated, replay");
  expectRefused("scene = \"atlantis\"\n", ":1:", "is not known; there are, in ");
  expectRefused("mode = \"ghost\"\n", ":1:", "must be one of: operator, robot");
  expectRefused("[network]\nredundancy = 8\n", ":2:", "from 0 to 7");
  expectRefused(
      "[netwrok]\nport = 1\n", ":1:",
      "known are: accuracy, frames, master, mode, network, prediction, rig, sampling, scene, world_seed");
  expectRefused("network = 3\n", ":1:", "must be a table");
  expectRefused("[master.replay]\nloop = 1\n", ":2:", "must be true or false");
}

TEST_F(ConfigTest, HowMotionIsDeliveredAndSeenIsRead) {
  const ServerConfig config = readServerConfig(write(R"(
[network]
encoding = "auto"
multicast = "239.255.74.30:7432"
discovery = false
[frames]
hz = 90
least_margin_ms = 4.5
most_margin_ms = 4.5
[prediction]
kind = "velocity"
horizon_ms = 0
[accuracy]
hand_mm = 1.5
view_px = 0.25
)"));
  EXPECT_EQ(config.encoding, "auto");
  EXPECT_EQ(config.multicast_address, "239.255.74.30");
  EXPECT_EQ(config.multicast_port, 7432);
  EXPECT_FALSE(config.discovery);
  EXPECT_EQ(config.frames_hz, 90.0);
  EXPECT_EQ(config.least_margin_ms, 4.5);
  EXPECT_EQ(config.most_margin_ms, 4.5);
  EXPECT_EQ(config.prediction, "velocity");
  EXPECT_EQ(config.horizon_ms, 0.0);
  EXPECT_EQ(config.hand_mm, 1.5);
  EXPECT_EQ(config.view_px, 0.25);
}

TEST_F(ConfigTest, WrongDeliveryIsRefusedWithPlaceAndRemedy) {
  expectRefused("[network]\nencoding = \"tight\"\n", ":2:", "must be one of: exact, compact, auto");
  expectRefused("[network]\ndiscovery = 1\n", ":2:", "must be true or false");
  for (const char* group :
       {"192.0.2.1:7432", "239.255.74.30", "239.255.74.30:0", "[ff02::1]:7432", "group:1"})
    expectRefused("[network]\n\nmulticast = \"" + std::string(group) + "\"\n",
                  ":3:", "right would be an IPv4 group of one's own with a port, as \"239.255.74.30:7432\"");
  expectRefused("[network]\nmulticast = \"239.255.74.30:70000\"\n", ":2:", "network.multicast");
  expectRefused("[frames]\nhz = 0\n", ":2:", "frames.hz: 0 is out of range; must be from 1 to 1000");
  expectRefused("[frames]\nhz = nan\n", ":2:", "frames.hz");
  expectRefused("[frames]\nleast_margin_ms = -1\n", ":2:", "must be from 0 to 1000");
  expectRefused("[frames]\nmost_margin_ms = 1\n",
                ":2:", "is below least_margin_ms; right would be at least that");
  expectRefused("[frames]\nleast_margin_ms = 200\n", ":1:", "frames.most_margin_ms: is below");
  expectRefused("[frames]\nmargin = 2\n", ":2:", "is not a known key");
  expectRefused("[prediction]\nkind = \"oracle\"\n", ":2:", "must be one of: none, velocity, kalman");
  expectRefused("[prediction]\nhorizon_ms = 201\n", ":2:", "must be from 0 to 200");
  expectRefused("[accuracy]\nhand_mm = -0.5\n", ":2:", "accuracy.hand_mm");
  expectRefused("[accuracy]\nview_px = \"few\"\n", ":2:", "accuracy.view_px");
}

TEST_F(ConfigTest, MissingFilesAreNamed) {
  EXPECT_NE(messageOf([] { readServerConfig("/nowhere/x.toml"); }).find("/nowhere/x.toml: no such file"),
            std::string::npos);
  const std::string path = write("rig = \"absent.toml\"\n");
  EXPECT_NE(messageOf([&] { readServerConfig(path); }).find("absent.toml: no such file"), std::string::npos);
}

TEST_F(ConfigTest, AFolderIsNoFile) {
  const std::string message = messageOf([&] { readServerConfig((folder_ / "scenes").string()); });
  EXPECT_NE(message.find("is a folder; name a TOML file in it, there are: laboratory"), std::string::npos)
      << message;
}

TEST_F(ConfigTest, PathsAreRelativeToTheFile) {
  write("upper_arm = 0.25\n", "servers/arm.toml");
  write("driving = false\n", "servers/my.toml");
  EXPECT_EQ(readServerConfig(write("rig = \"arm.toml\"\n")).rig.upper_arm, 0.25);
  EXPECT_FALSE(readServerConfig(write("scene = \"my.toml\"\n")).scene.driving);
}

TEST_F(ConfigTest, ScenesSayWhatIsInThem) {
  const std::string path = write(R"(
operator = "eyes"
start = [1.0, -2.0, 90.0]
scatter = [0.0, 1.0, 2.0, 3.0]
[robot]
start = [0.5, 0.25, 0.0]
[[object]]
kind = "table"
position = [0.0, 0.1, -1.2]
heading = -90.0
[[object]]
kind = "block"
name = "the red one"
colour = "#ff0000"
)",
                                 "scenes/mine.toml");
  for (const SceneDescription& scene :
       {readScene(path, ""), readScene("mine", (folder_ / "scenes").string())}) {
    EXPECT_EQ(scene.name, "mine");
    EXPECT_FALSE(scene.operator_shown);
    EXPECT_TRUE(scene.driving);
    EXPECT_EQ(scene.start, (BasePose{1'000'000'000, 0, -2'000'000'000, 1 << 30}));
    EXPECT_EQ(scene.workplace, scene.start);
    ASSERT_TRUE(scene.robot);
    EXPECT_EQ(scene.robot->workplace, (BasePose{500'000'000, 0, 250'000'000, 0}));
    EXPECT_EQ(scene.scatter, (ScatterArea{0.0, 1.0, 2.0, 3.0}));
    ASSERT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.objects[0],
              (ObjectPlacement{"table", "table", {0, 100'000'000, -1'200'000'000, -(1 << 30)}, "", 0}));
    EXPECT_EQ(scene.objects[1].name, "the red one");
    EXPECT_EQ(scene.objects[1].colour, "#ff0000");
  }
}

TEST_F(ConfigTest, WrongScenesAreRefusedWithPlaceAndRemedy) {
  const auto refused = [&](const std::string& text, const std::string& place, const std::string& words) {
    const std::string path = write(text, "scenes/bad.toml");
    const std::string message = messageOf([&] { readScene(path, ""); });
    EXPECT_NE(message.find("bad.toml" + place), std::string::npos) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  refused("[[object]]\nkind = \"unicorn\"\n",
          ":2:", "\"unicorn\" is no kind of object; there are laboratory");
  refused("\n[[object]]\nname = \"x\"\n", ":2:", "object[0].kind: is missing");
  refused("[[object]]\nkind = \"table\"\nname = \"Tisch f\u00fcr alle\"\n",
          ":3:", "object[0].name: \"Tisch f\u00fcr alle\" is shown on every machine");
  refused("[[object]]\nkind = \"table\"\ncolour = \"#ff0000\"\n", ":3:", "a table comes in no colours");
  refused("[[object]]\nkind = \"block\"\ncolour = \"reddish\"\n",
          ":3:", "\"reddish\" is no colour; write it as \"#c8433a\"");
  refused("\n[[object]]\nkind = \"grid\"\n", ":2:", "a grid needs a count of 1 or more");
  refused("[[object]]\nkind = \"table\"\n[[object]]\nkind = \"table\"\n",
          ":3:", "two objects are called 'table'");
  refused("[[object]]\nkind = \"grid\"\ncount = 200001\n", ":3:", "from 1 to 200000");
  refused(
      "[[object]]\nkind = \"grid\"\ncount = 200000\n[[object]]\nkind = \"grid\"\nname = \"b\"\ncount = 1\n",
      ":7:", "all counts of a scene together may be 200000; with this one they are 200001");
  refused("[[object]]\nkind = \"table\"\nposition = [1.0, 2.0]\n", ":3:", "must be 3 numbers");
  refused("[[object]]\nkind = \"table\"\nposition = [2e9, 0.0, 0.0]\n",
          ":3:", "from -1000000000 to 1000000000");
  refused("[[object]]\nkind = \"table\"\nposition = [nan, 0.0, 0.0]\n", ":3:", "must be 3 numbers");
  refused("[[object]]\nkind = \"table\"\nheadnig = 1.0\n", ":3:", "is not a known key");
  refused("[[object]]\nkind = \"table\"\ncount = 3\n", ":3:", "is not a known key");
  refused("start = [0.0, 0.0, \"left\"]\n", ":1:", "must be 3 numbers");
  refused("scatter = [1.0, 0.0, 2.0, 3.0]\n", ":1:", "no larger than its to");
  refused("object = 3\n", ":1:", "must be tables: [[object]]");
  refused("operator = \"ghost\"\n", ":1:", "must be one of: whole, eyes");
  const std::string folder = (folder_ / "scenes").string();
  EXPECT_NE(messageOf([&] { readScene("laboratory:x", folder); }).find("whole number"), std::string::npos);
  EXPECT_NE(messageOf([&] { readScene("laboratory:0", folder); }).find("from 1 to"), std::string::npos);
  EXPECT_NE(messageOf([&] { readScene("atlantis", folder); }).find("bad, laboratory"), std::string::npos);
  EXPECT_NE(messageOf([&] { readScene("laboratory:3", folder); }).find("write \"laboratory\""),
            std::string::npos);
  for (const char* name : {"", "../scenes/laboratory", "a b", "J\u00f6rg", ":3", "a/b.tom"})
    EXPECT_NE(messageOf([&] { readScene(name, folder); }).find("is no name"), std::string::npos) << name;
  const std::string blank = write("", "scenes/my scene.toml");
  EXPECT_NE(messageOf([&] { readScene(blank, ""); }).find("my scene.toml: the file's name is the scene's"),
            std::string::npos);
}

TEST_F(ConfigTest, ACountGoesToWhatNeedsOne) {
  write("[[object]]\nkind = \"grid\"\n[[object]]\nkind = \"grid\"\nname = \"b\"\ncount = 7\n",
        "scenes/g.toml");
  const SceneDescription scene = readScene("g:50", (folder_ / "scenes").string());
  EXPECT_EQ(scene.name, "g:50");
  EXPECT_EQ(scene.objects[0].count, 50);
  EXPECT_EQ(scene.objects[1].count, 7);
  EXPECT_EQ(sceneFile("g:50", (folder_ / "scenes").string()), (folder_ / "scenes/g.toml").string());
}

TEST_F(ConfigTest, AbsurdRigsAreRefused) {
  for (const char* text : {"upper_arm = -0.3\n", "upper_arm = 30.0\n", "eye_distance = nan\n", "leg = 1.0\n"})
    EXPECT_THROW(readRig(write(text)), ConfigError) << text;
}

TEST_F(ConfigTest, ARigsNameIsPlain) {
  write("upper_arm = 0.3\nname = \"J\u00f6rg\"\n", "servers/r.toml");
  EXPECT_NE(messageOf([&] { readRig((folder_ / "servers/r.toml").string()); }).find("r.toml:2:8: name:"),
            std::string::npos);
  const std::string by_file = write("upper_arm = 0.3\n", "servers/J\u00f6rg.toml");
  EXPECT_NE(messageOf([&] { readRig(by_file); }).find("name:"), std::string::npos);
}

TEST_F(ConfigTest, MeasuresThatARigLeavesOutAreNamed) {
  std::vector<std::string> absent;
  readRig((fs::path(COHERENCY_CONFIGS) / "rigs/default.toml").string(), &absent);
  EXPECT_TRUE(absent.empty());
  readRig(write("upper_arm = 0.25\n"), &absent);
  EXPECT_EQ(absent.size(), rigFields().size() - 1);
  EXPECT_EQ(absent.front(), "eye_distance");
}

TEST_F(ConfigTest, TheShippedRigSaysWhatItsMeasuresMayBe) {
  std::ifstream file(fs::path(COHERENCY_CONFIGS) / "rigs/default.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const RigField& field : rigFields()) {
    const auto line = text.find("\n" + std::string(field.name) + " = ");
    ASSERT_NE(line, std::string::npos) << field.name;
    std::ostringstream range;
    range << field.min << " to " << field.max << "\n";
    const std::string whole = text.substr(line + 1, text.find('\n', line + 1) - line);
    EXPECT_TRUE(whole.ends_with(range.str())) << whole << " must end with " << range.str();
  }
}

TEST_F(ConfigTest, TheListOfObjectsIsTheCatalogue) {
  std::ifstream file(COHERENCY_DOCS "/scenes.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::string table;
  for (const CatalogueEntry& e : catalogue()) {
    const char* takes = e.coloured ? "colour" : (e.counted ? "count" : "");
    table += "| `" + std::string(e.kind) + "` | " + std::string(e.what) + " | " + takes + " |\n";
  }
  EXPECT_NE(text.find("|---|---|---|\n" + table + "\n"), std::string::npos)
      << "docs/scenes.md must have this table:\n"
      << table;
}

TEST_F(ConfigTest, Endpoints) {
  EXPECT_EQ(parseEndpoint("pc1", 7).port, 7);
  EXPECT_EQ(parseEndpoint("pc1:80", 7).port, 80);
  EXPECT_EQ(parseEndpoint("[::1]:80", 7).host, "::1");
  EXPECT_EQ(parseEndpoint("[::1]", 7).port, 7);
  for (const char* wrong :
       {"", ":80", "pc1:", "pc1:x", "pc1:70000", "pc1:-1", "::1", "[::1", "[::1]x", "[::1]:"})
    EXPECT_THROW(parseEndpoint(wrong, 7), ConfigError) << wrong;
  EXPECT_NE(messageOf([] { parseEndpoint("7430", 7430); }).find("right would be"), std::string::npos);
  EXPECT_EQ(describe({"::1", 80}), "[::1]:80");
  EXPECT_EQ(describe({"pc1", 80}), "pc1:80");
}

TEST_F(ConfigTest, AddressesToListenOnAreNumbers) {
  EXPECT_EQ(parseListenEndpoint("localhost:80", 7).host, "127.0.0.1");
  EXPECT_EQ(parseListenEndpoint("[0:0::1]", 7).host, "::1");
  EXPECT_EQ(parseListenEndpoint("0.0.0.0:0", 7).port, 0);
  EXPECT_EQ(listenAddress("fe80::1%eth0"), "fe80::1%eth0");
  for (const char* wrong : {"7430", "foo", "foo:1", "", "127.0.0.1:99999", "1.2.3", "1.2.3.4%eth0:1"}) {
    const std::string message = messageOf([&] { parseListenEndpoint(wrong, 7430); });
    EXPECT_NE(message.find("right would be 127.0.0.1:7430"), std::string::npos) << message;
  }
  EXPECT_TRUE(isLoopback("::1") && isLoopback("127.0.0.2"));
  EXPECT_FALSE(isLoopback("0.0.0.0") || isLoopback("192.0.2.1"));
  EXPECT_EQ(readServerConfig(write("[network]\naddress = \"localhost\"\n")).address, "127.0.0.1");
  expectRefused("[network]\naddress = \"foo\"\n", ":2:", "right would be \"127.0.0.1\"");
}

TEST_F(ConfigTest, WhetherAFileCanBeWrittenIsKnownBefore) {
  EXPECT_NO_THROW(checkReplaceable("--stats-json", ""));
  EXPECT_NO_THROW(checkReplaceable("--stats-json", "beside_me.json"));
  EXPECT_NO_THROW(checkReplaceable("--stats-json", "/dev/null"));
  EXPECT_NO_THROW(checkReplaceable("--stats-json", (folder_ / "new.json").string()));
  EXPECT_FALSE(fs::exists(folder_ / "new.json"));
  EXPECT_NE(messageOf([] { checkReplaceable("--stats-json", "/nope/x"); }).find("there is no folder /nope"),
            std::string::npos);
  EXPECT_NE(messageOf([&] { checkReplaceable("--stats-json", folder_.string()); }).find("is a folder"),
            std::string::npos);
}

TEST_F(ConfigTest, ReplacedFilesAreWholeOrNamed) {
  const std::string path = (folder_ / "a.json").string();
  replaceFile(path, "one");
  replaceFile(path, "two");
  std::ifstream file(path);
  std::string text;
  file >> text;
  EXPECT_EQ(text, "two");
  EXPECT_FALSE(fs::exists(path + ".new"));
  EXPECT_THROW(replaceFile("/nowhere/at/all.json", "x"), std::runtime_error);

  const std::string link = (folder_ / "link.json").string();
  fs::create_symlink(path, link);
  replaceFile(link, "three");
  EXPECT_TRUE(fs::is_symlink(link)) << "a link stays a link";
  replaceFile("/dev/null", "nothing");
  EXPECT_TRUE(fs::is_character_file("/dev/null")) << "a device stays a device";
}

}  // namespace
}  // namespace coherency
