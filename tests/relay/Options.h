#pragma once

#include <cstdint>
#include <string>

#include "common/config/Endpoint.h"
#include "tests/relay/RelaySettings.h"

namespace coherency {

struct RelayOptions {
  Endpoint listen;  ///< TCP and UDP, for the clients
  Endpoint server;  ///< TCP and UDP; numeric, as `listen` is
  std::uint64_t seed = 0;
  RelaySettings settings;
  std::int64_t flow_silence_ns = 10'000'000'000;  ///< a client's UDP is forgotten after so much silence
  bool until_stdin_closes = false;
  std::string stats_json;  ///< file; empty: none
};

/// Reads the command line. `exit_code` is -1 when the relay is to run, else what to end with; what was wrong
/// has then been said on stderr.
RelayOptions parseRelayOptions(int argc, char** argv, int& exit_code);

}  // namespace coherency
