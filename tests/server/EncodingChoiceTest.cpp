#include <gtest/gtest.h>

#include "motion_server/EncodingChoice.h"

namespace coherency {
namespace {

ServerConfig choosing(const std::string& encoding, double hand_mm = 0.0, double view_px = 0.0) {
  ServerConfig config;
  config.encoding = encoding;
  config.hand_mm = hand_mm;
  config.view_px = view_px;
  return config;
}

TEST(EncodingChoice, IsAsConfigured) {
  EXPECT_FALSE(chooseEncoding(choosing("exact", 1000.0, 1000.0)).compact);
  EXPECT_TRUE(chooseEncoding(choosing("compact")).compact) << "whatever the budgets";
  EXPECT_NE(chooseEncoding(choosing("compact")).reason.find("as configured"), std::string::npos);
}

TEST(EncodingChoice, AutoIsCompactWhereBothBudgetsHold) {
  const double hand = compactHandMm(Rig{}), view = compactViewPx();
  EXPECT_TRUE(chooseEncoding(choosing("auto", hand, view)).compact);
  EXPECT_FALSE(chooseEncoding(choosing("auto", hand * 0.999, view)).compact);
  EXPECT_FALSE(chooseEncoding(choosing("auto", hand, view * 0.999)).compact);
  EXPECT_FALSE(chooseEncoding(choosing("auto")).compact) << "no budget, no error";
  const std::string within = chooseEncoding(choosing("auto", 5.0, 50.0)).reason;
  EXPECT_NE(within.find("within the budgets of 5 mm and 50 px"), std::string::npos) << within;
  const std::string beyond = chooseEncoding(choosing("auto", 0.0, 50.0)).reason;
  EXPECT_NE(beyond.find("exact: "), std::string::npos) << beyond;
  EXPECT_NE(beyond.find("beyond the budgets"), std::string::npos) << beyond;
}

TEST(EncodingChoice, LongerArmsCostMore) {
  Rig longer;
  longer.forearm *= 2.0;
  EXPECT_GT(compactHandMm(longer), compactHandMm(Rig{}));
  EXPECT_GT(compactHandMm(Rig{}), 0.05);
  EXPECT_LT(compactHandMm(Rig{}), 2.0);
}

}  // namespace
}  // namespace coherency
