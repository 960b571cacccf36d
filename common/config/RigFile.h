#pragma once

#include <string>
#include <vector>

#include "common/body/Rig.h"

namespace coherency {

/// The operator's measures from a TOML file (configs/rigs/): the keys are rigFields()' names, metres and
/// radians; a measure that is absent keeps Rig's default, and its name is added to `absent`. Throws
/// ConfigError.
Rig readRig(const std::string& path, std::vector<std::string>* absent = nullptr);

}  // namespace coherency
