#include <gtest/gtest.h>

#include "tests/relay/RelaySettings.h"

namespace coherency {
namespace {

TEST(RelaySettings, LinesChangeOneSettingEach) {
  RelaySettings settings;
  for (const char* line :
       {"loss 0.1", "burst-every-ms 1000", "burst-ms 20", "burst-regular on", "delay-ms 0.25", "jitter-ms 5",
        "reorder on", "duplicate 0.01", "corrupt 1e-3", "block-udp true", "  tcp-delay-ms   40 "})
    EXPECT_EQ(changeSetting(line, settings), "") << line;
  const ImpairmentSettings expected{.loss = 0.1,
                                    .burst_every_ns = 1'000'000'000,
                                    .burst_ns = 20'000'000,
                                    .bursts_regular = true,
                                    .delay_ns = 250'000,
                                    .jitter_ns = 5'000'000,
                                    .reorder = true,
                                    .duplicate = 0.01,
                                    .corrupt = 0.001,
                                    .block = true};
  EXPECT_EQ(settings.udp, expected);
  EXPECT_EQ(settings.tcp_delay_ns, 40'000'000);
  EXPECT_EQ(changeSetting("block-udp off", settings), "");
  EXPECT_FALSE(settings.udp.block);
  EXPECT_EQ(settings.udp.loss, 0.1);
}

TEST(RelaySettings, BurstsEndByTheirPeriodAlone) {
  RelaySettings settings;
  ASSERT_EQ(changeSetting("burst-ms 20", settings), "");
  ASSERT_EQ(changeSetting("burst-every-ms 100", settings), "");
  EXPECT_EQ(changeSetting("burst-every-ms 0", settings), "");
}

TEST(RelaySettings, AWrongLineIsSaidAndChangesNothing) {
  RelaySettings settings;
  settings.udp.loss = 0.25;
  const RelaySettings before = settings;
  for (const char* line :
       {"", "loss", "loss 0.1 0.2", "loss 1.5", "loss nan", "loss -1", "loss x", "--loss 0.1", "lost 0.1",
        "reorder maybe", "delay-ms -1", "delay-ms 1e9", "burst-every-ms 0.5", "help on", "loss=0 0"}) {
    EXPECT_NE(changeSetting(line, settings), "") << line;
    EXPECT_EQ(settings.udp, before.udp) << line;
  }
}

}  // namespace
}  // namespace coherency
