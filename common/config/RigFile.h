#pragma once

#include <string>

#include "common/body/Rig.h"

namespace coherency {

/// The operator's measures from a TOML file (configs/rigs/): the keys are rigFields()' names, metres and
/// radians; a measure that is absent keeps Rig's default. Throws ConfigError.
Rig readRig(const std::string& path);

}  // namespace coherency
