#pragma once

#include <set>
#include <string>
#include <vector>

#include "motion_server/broadcast/Broadcaster.h"

namespace coherency {

/// Tells who has come and who has left since it was last asked, a line each, and of those who did both: what
/// a log is to say of a session.
class ClientNews {
 public:
  std::vector<std::string> since(const std::vector<ClientStatus>& clients);

 private:
  std::set<std::uint32_t> here_;
  std::uint32_t newest_ = 0;  ///< client's number; they rise
};

}  // namespace coherency
