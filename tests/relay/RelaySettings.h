#pragma once

#include <cstdint>
#include <string>

#include "tests/relay/Impairment.h"

namespace CLI {
class App;
}

namespace coherency {

/// All that may change while a relay runs. The default passes everything on at once.
struct RelaySettings {
  ImpairmentSettings udp;
  std::int64_t tcp_delay_ns = 0;  ///< in each direction; nothing of TCP is lost or changed
};

/// Declares --loss, --delay-ms and so on, which write into `settings`.
void declareSettings(CLI::App& app, RelaySettings& settings);

/// Changes one setting by a line "NAME VALUE", NAME as the option without its dashes: "loss 0.1",
/// "block-udp on". Returns what is wrong with it, and then changes nothing; empty when nothing is.
std::string changeSetting(const std::string& line, RelaySettings& settings);

}  // namespace coherency
