#pragma once

#include <string>

#include "common/config/ServerConfig.h"
#include "common/wire/Key.h"

namespace coherency {

/// The command line over the configuration file.
struct ServerOptions {
  ServerConfig config;
  double duration_s = 0.0;  ///< 0: until a signal
  std::string stats_json;   ///< empty: none
  Key key = kNoKey;         ///< that clients must have
  std::string make_key;     ///< empty: none to be made
  bool list_devices = false;
  bool list_objects = false;
};

/// Parses arguments and reads the configuration they name. `exit_code` is set where the program should end at
/// once: 0 after --help or --version, 2 for anything wrong, which has then been said on stderr.
ServerOptions parseServerOptions(int argc, char** argv, int& exit_code);

}  // namespace coherency
