#pragma once

#include <functional>
#include <string>
#include <vector>

namespace coherency {

/// Numeric addresses of a host's name, in the system's order of preference; an address is its own name.
struct NameAnswer {
  std::vector<std::string> addresses;
  std::string error;  ///< if there are none: why
};

/// Asks the system's resolver on a thread of its own and gives the answer to `done` on that thread. The
/// resolver cannot be interrupted and may take many seconds: the thread is let go, so `done` must own what it
/// touches.
void lookUpName(const std::string& host, std::function<void(const NameAnswer&)> done);

}  // namespace coherency
