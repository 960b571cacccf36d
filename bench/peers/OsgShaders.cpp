#include "bench/peers/OsgShaders.h"

#include "render_client/compile/CompiledScene.h"

namespace coherency {
namespace {

const char* const kLit = R"(
layout(location = 0) out vec3 light;
layout(location = 1) out vec4 shadow_at;
void main() {
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
  light = BRIGHTEST * gl_Color.rgb;
}
)";

const char* const kMapped = R"(
layout(location = 0) out vec2 place;
layout(location = 1) out vec4 shadow_at;
layout(location = 2) flat out vec4 colour;
void main() {
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
  place = gl_MultiTexCoord0.xy;
  colour = vec4(gl_Color.rgb * gl_Color.rgb, gl_Color.a);
}
)";

// As movingVertexShader() has it, in the eye's axes.
const char* const kMoving = R"(
layout(location = 0) out vec3 light;
layout(location = 1) out vec4 shadow_at;
uniform vec3 up;
uniform float emission;
uniform vec4 from_above, from_below, others;
uniform vec4 position_reach[4], colour[4];

float falloff(float square, float reach) {
  float x = square / (reach * reach);
  float fade = max(1.0 - x * x, 0.0);
  return fade * fade / max(square, 0.25);
}

void main() {
  vec3 p = (gl_ModelViewMatrix * gl_Vertex).xyz;
  gl_Position = gl_ProjectionMatrix * vec4(p, 1.0);
  vec3 n = normalize(gl_NormalMatrix * gl_Normal);
  vec3 to_eye = normalize(-p);
  vec3 irradiance = mix(from_below.rgb, from_above.rgb + others.rgb, 0.5 + 0.5 * dot(n, up));
  vec3 highlights = vec3(0.0);
  for (int i = 0; i < LAMPS; ++i) {
    vec3 l = position_reach[i].xyz - p;
    float square = dot(l, l);
    l *= inversesqrt(square);
    vec3 reaching = colour[i].rgb * (falloff(square, position_reach[i].w) * max((dot(n, l) + 0.1) / 1.1, 0.0));
    float highlight = max(dot(n, normalize(l + to_eye)), 0.0);
    for (int squaring = 0; squaring < 5; ++squaring) highlight *= highlight;
    irradiance += reaching;
    highlights += reaching * highlight;
  }
  light = mix(gl_Color.rgb * irradiance + 0.5 * gl_Color.a * highlights, gl_Color.rgb, emission);
}
)";

std::string defined(std::size_t lamps) {
  return "#version 450 compatibility\n#define LAMPS " + std::to_string(lamps) + "\n#define BRIGHTEST " +
         std::to_string(PackedLight::kBrightest) + "\n";
}

}  // namespace

std::string osgFixedVertexShader(const ShaderVariant& variant) {
  return defined(0) + (variant.light == LightSource::Lightmap ? kMapped : kLit);
}

std::string osgMovingVertexShader(const ShaderVariant& variant) {
  return defined(variant.lamps) + kMoving;
}

std::string osgFragmentShader(const ShaderVariant& variant) {
  std::string text = fragmentShader(variant);
  const std::string core = "450 core";
  return text.replace(text.find(core), core.size(), "450 compatibility");
}

}  // namespace coherency
