#pragma once

#include <functional>
#include <memory>
#include <string>

#include "common/wire/Discovery.h"

namespace coherency {

/// Answers who searches for servers on the network (kDiscoveryPort, broadcast). A server that listens on
/// loopback alone answers its own machine alone. Any number of servers on one machine answer.
class Announcer {
 public:
  /// `address`: the one the server listens on. `say` is asked for each answer, from a thread of this object's
  /// own. Throws std::runtime_error naming the port where it cannot be bound.
  Announcer(const std::string& address, std::function<Announcement()> say);
  ~Announcer();
  Announcer(const Announcer&) = delete;
  Announcer& operator=(const Announcer&) = delete;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
