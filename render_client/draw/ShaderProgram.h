#pragma once

#include <string>

#include "render_client/draw/GlObjects.h"

namespace coherency {

/// Throws std::runtime_error with `name` and the driver's log when a stage does not compile or they do not
/// link.
Program makeProgram(const std::string& name, const std::string& vertex_source,
                    const std::string& fragment_source);

}  // namespace coherency
