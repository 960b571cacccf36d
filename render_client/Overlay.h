#pragma once

#include <cstdint>
#include <string>

#include "common/sync/Clock.h"
#include "render_client/StatsReport.h"
#include "render_client/replica/Replica.h"

namespace coherency {

/// The lines of text over the picture: statistics on request, what the other senses tell, notices that pass,
/// a warning where nothing has come for a while, and the keys at the beginning.
class Overlay {
 public:
  /// `server` is its name in the warning.
  Overlay(std::string server, ClientTime started) : server_(std::move(server)), started_(started) {}

  void toggle() { shown_ = !shown_; }
  /// Twice a second; costs nothing while the statistics are not shown.
  void refresh(const ClientStats& stats, const Replica& replica);
  void notify(std::string notice, ClientTime now);

  /// What to show now; empty for nothing. `silent_ns`: how long no motion has come. `keys`: whether anybody
  /// can press any.
  std::string text(ClientTime now, std::int64_t silent_ns, const Replica& replica, bool keys) const;

 private:
  std::string server_;
  ClientTime started_;
  bool shown_ = false;
  std::string statistics_;
  std::string notice_;
  ClientTime noticed_;
};

}  // namespace coherency
