#pragma once

#include <string>

#include "common/config/ServerConfig.h"

namespace coherency {

/// Which encoding samples travel in, and why.
struct EncodingChoice {
  bool compact = false;
  std::string reason;  ///< for people
};

/// As configured; "auto" takes the compact one (CompactCode.h) where the most that it can move the hand, and
/// what the operator sees, stays within the budgets of [accuracy].
EncodingChoice chooseEncoding(const ServerConfig& config);

/// The most that the compact encoding can move the palm, by all joints together, mm.
double compactHandMm(const Rig& rig);
/// The most that it can move what is seen half a metre ahead, in a picture of 20 pixels a degree, px.
double compactViewPx();

}  // namespace coherency
