#include "bench/peers/FloorShaders.h"

#include "render_client/compile/CompiledScene.h"

namespace coherency {

std::string bareVertexShader(bool mapped, bool marking) {
  return "#version 450 core\n#define MAPPED " + std::to_string(mapped ? 1 : 0) + "\n#define MARKING " +
         std::to_string(marking ? 1 : 0) + "\n#define BRIGHTEST " + std::to_string(PackedLight::kBrightest) +
         R"(
layout(location = 0) uniform mat4 to_clip;
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 baked;
layout(location = 2) in uint object;
layout(location = 3) in vec4 material;
layout(location = 1) out vec4 shadow_at;
#if MARKING
layout(location = 3) flat out uint number;
#endif
#if MAPPED
layout(location = 0) out vec2 place;
layout(location = 2) flat out vec4 colour;
#else
layout(location = 0) out vec3 light;
#endif
void main() {
  gl_Position = to_clip * vec4(position, 1.0);
#if MARKING
  number = object;
#endif
#if MAPPED
  place = baked.xy;
  colour = vec4(material.rgb * material.rgb, material.a);
#else
  light = BRIGHTEST * baked.rgb;
#endif
}
)";
}

const char* const kMarkingFragmentShader = R"(#version 450 core
layout(early_fragment_tests) in;
layout(std430, binding = 2) readonly buffer FirstTriangles { uint first_triangles[]; };
layout(std430, binding = 3) writeonly buffer Marks { uint marks[]; };
layout(location = 3) flat in uint number;
void main() { marks[first_triangles[number] + gl_PrimitiveID] = 1; }
)";

}  // namespace coherency
