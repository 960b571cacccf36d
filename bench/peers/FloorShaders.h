#pragma once

#include <string>

namespace coherency {

// The floor's own shaders, GLSL 4.50; the others are the renderer's.

/// For what never moves: its vertices are relative to the eye, and what it sends to the eye is in them.
/// `marking`: goes with kMarkingFragmentShader.
std::string bareVertexShader(bool mapped, bool marking);
/// Marks the triangles of which a fragment passes the depth test (FloorPass); goes with ShaderVariant::ids.
extern const char* const kMarkingFragmentShader;

}  // namespace coherency
