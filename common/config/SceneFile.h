#pragma once

#include <string>

#include "common/world/SceneDescription.h"

namespace coherency {

/// The scene called `scene`: a name stands for the file NAME.toml in `folder`, NAME:N besides gives N as the
/// count to those of its objects that need one, and what ends in .toml is a path. Keys are those of
/// configs/scenes/laboratory.toml. Throws ConfigError for all that one object by itself can have wrong;
/// whether the objects fit together is found out by Scene.
SceneDescription readScene(const std::string& scene, const std::string& folder);

/// The file that readScene() reads. Throws ConfigError where `scene` is no name or path, or is not known.
std::string sceneFile(const std::string& scene, const std::string& folder);

}  // namespace coherency
