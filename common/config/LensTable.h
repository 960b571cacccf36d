#pragma once

#include "common/config/HmdProfile.h"
#include "common/config/TomlTable.h"

namespace coherency {

/// Reads an eye's `lens` table, which must have been given. Throws ConfigError where a number is missing or
/// out of range, the centre is not on the panel, or a colour's curve does not rise to the lens's border.
Lens readLens(TomlTable& eye, const PanelSize& panel);

}  // namespace coherency
