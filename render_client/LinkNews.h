#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "render_client/receive/ServerLink.h"

namespace coherency {

/// Tells when the server was lost, when it is back and by which way motion comes, a line each: what a log is
/// to say of a run.
class LinkNews {
 public:
  explicit LinkNews(std::string server) : server_(std::move(server)) {}

  /// What has changed since it was last asked, if anything has.
  std::optional<std::string> since(const LinkStats& link);

 private:
  std::string server_;
  bool connected_ = true;
  std::uint64_t connections_ = 1;
  MotionWay way_ = MotionWay::Udp;
};

}  // namespace coherency
