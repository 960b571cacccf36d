#pragma once

#include <string>

#include "render_client/draw/ShaderSources.h"

namespace coherency {

// This project's shaders, with OpenSceneGraph's matrices and attributes in place of its own.

std::string osgFixedVertexShader(const ShaderVariant& variant);
std::string osgMovingVertexShader(const ShaderVariant& variant);
/// The very same, in the compatibility profile.
std::string osgFragmentShader(const ShaderVariant& variant);

}  // namespace coherency
