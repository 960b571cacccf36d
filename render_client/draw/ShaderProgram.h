#pragma once

#include <string>

#include "render_client/draw/GlObjects.h"

namespace coherency {

/// Throws std::runtime_error with `name` and the driver's log when a stage does not compile or they do not
/// link.
Program makeProgram(const std::string& name, const std::string& vertex_source,
                    const std::string& fragment_source);

/// Whether the driver draws a picture faster where depth is tested after shading (ShaderVariant). llvmpipe
/// does, by a fifth with four samples a pixel (docs/measurements.md); a GPU shades less where it tests first.
bool cheaperWithDepthLast();

}  // namespace coherency
