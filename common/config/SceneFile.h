#pragma once

#include <string>

#include "common/world/SceneDescription.h"

namespace coherency {

/// The scene called `scene`: a name stands for the file NAME.toml in `folder`, NAME:N besides gives N as the
/// count to those of its objects that need one, and what ends in .toml is a path. Keys are those of
/// configs/scenes/laboratory.toml. Throws ConfigError, for objects of unknown kinds too; whether all fits
/// together is found out by Scene.
SceneDescription readScene(const std::string& scene, const std::string& folder);

}  // namespace coherency
