#pragma once

#include <string>

namespace coherency {

/// The folder of the configurations that come with the programs, of one kind ("servers", "scenes", "hmds"):
/// configs/KIND in the current folder or above the program's file, as in a build tree, else
/// share/coherency/KIND where the programs were installed. Empty where there is none.
std::string shippedFolder(const std::string& kind);

/// Names of the TOML files in a folder, without their ending, in order with commas between; "none" where
/// there are none.
std::string namesIn(const std::string& folder);

}  // namespace coherency
