#include "render_client/draw/ShaderSources.h"

namespace coherency {

namespace {

// Light is computed at the vertices (compile/Refine.h makes them dense enough) and only the first light's
// shadow in the picture's pixels: on a software renderer a pixel's light costs ten times a vertex's.
const char* const kSceneVertexBody = R"(
struct Object {
  mat4 eye_from_mesh;
  vec4 normal_x_emission;
  vec4 normal_y;
  vec4 normal_z;
  vec4 colour_gloss;
};
layout(std430, binding = 0) readonly buffer Objects { Object objects[]; };
layout(std140, binding = 0) uniform View {
  mat4 clip_from_eye;
  mat4 shadow_from_eye;
  vec4 up;
  vec4 sky;
  vec4 ground;
  vec4 shadow;             // a texel's width at 1 m from the light
  vec4 light_position[8];  // eye frame, m
  vec4 light_colour[8];    // irradiance at 1 m
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uint object;

layout(location = 0) out vec3 light;        // what the surface sends to the eye, but for the first light's share,
layout(location = 1) out vec3 first_light;  // which is this where nothing is in its way
layout(location = 2) out vec4 shadow_at;

void main() {
  vec4 p = objects[object].eye_from_mesh * vec4(position, 1.0);
  gl_Position = clip_from_eye * p;
  vec3 n = normalize(mat3(objects[object].normal_x_emission.xyz, objects[object].normal_y.xyz,
                          objects[object].normal_z.xyz) * normal);
  vec3 to_eye = normalize(-p.xyz);
  vec3 colour = objects[object].colour_gloss.rgb;
  float gloss = 0.5 * objects[object].colour_gloss.a;
  float emission = objects[object].normal_x_emission.w;

  light = colour * mix(ground.rgb, sky.rgb, 0.5 + 0.5 * dot(n, up.xyz));
  first_light = vec3(0.0);
  for (int i = 0; i < LIGHTS; ++i) {
    vec3 l = light_position[i].xyz - p.xyz;
    float square = dot(l, l);
    l *= inversesqrt(square);
    float wrapped = max((dot(n, l) + 0.1) / 1.1, 0.0);
    float highlight = max(dot(n, normalize(l + to_eye)), 0.0);
    for (int squaring = 0; squaring < 5; ++squaring) highlight *= highlight;  // to the 32nd power
    vec3 share = light_colour[i].rgb * (wrapped / (square + 0.01)) * (colour + highlight * gloss);
    if (i == 0 && SHADOWS) first_light = share; else light += share;
  }
  light = mix(light, colour, emission);
  first_light *= 1.0 - emission;

  // The point is moved off its surface by a texel and a half, and towards the light by 2 mm a metre, so that a surface
  // does not shade itself. Depth is reversed: nearer to the light is greater.
  float w = (shadow_from_eye * p).w;
  vec4 s = shadow_from_eye * vec4(p.xyz + n * (1.5 * shadow.x * w), 1.0);
  shadow_at = vec4(0.5 * (s.xy + s.w), 1.002 * s.z, s.w);
}
)";

const char* const kSceneFragmentBody = R"(
layout(binding = 0) uniform sampler2DShadow shadow_map;
layout(location = 0) in vec3 light;
layout(location = 1) in vec3 first_light;
layout(location = 2) in vec4 shadow_at;
layout(location = 0) out vec4 picture;

// Straight up to 0.6, then a shoulder that reaches 1 at infinity: nothing clips.
vec3 tone(vec3 c) {
  vec3 over = max(c - 0.6, 0.0) / 0.4;
  return min(c, 0.6) + 0.4 * over / (1.0 + over);
}

void main() {
  // Softened over two texels by the sampler; outside the map, and above the light, nothing is in shadow.
  float lit = SHADOWS && shadow_at.w > 0.0 ? textureProj(shadow_map, shadow_at) : 1.0;
  picture = vec4(tone(light + lit * first_light), 1.0);
}
)";

std::string withDefinitions(const char* body, std::size_t lights, bool shadows) {
  return "#version 450 core\n#define LIGHTS " + std::to_string(lights) + "\n#define SHADOWS " +
         (shadows ? "true" : "false") + body;
}

}  // namespace

std::string sceneVertexShader(std::size_t lights, bool shadows) {
  return withDefinitions(kSceneVertexBody, lights, shadows);
}

std::string sceneFragmentShader(std::size_t lights, bool shadows) {
  return withDefinitions(kSceneFragmentBody, lights, shadows);
}

const char* const kShadowVertexShader = R"(#version 450 core
layout(std430, binding = 0) readonly buffer Objects { mat4 light_from_mesh[]; };
layout(location = 0) in vec3 position;
layout(location = 2) in uint object;
void main() { gl_Position = light_from_mesh[object] * vec4(position, 1.0); }
)";

const char* const kShadowFragmentShader = R"(#version 450 core
void main() {}
)";

const char* const kTextVertexShader = R"(#version 450 core
layout(location = 0) uniform vec4 pixels;  // 2 / view's width, 2 / view's height, scale, -
layout(location = 0) in vec2 position;     // pixels from the top left corner
void main() { gl_Position = vec4(position * pixels.xy * pixels.z * vec2(1, -1) + vec2(-1, 1), 0, 1); }
)";

const char* const kTextFragmentShader = R"(#version 450 core
layout(location = 1) uniform vec4 colour;
layout(location = 0) out vec4 picture;
void main() { picture = colour; }
)";

}  // namespace coherency
