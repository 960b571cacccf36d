#include "render_client/draw/ShaderSources.h"

namespace coherency {

const char* const kSceneVertexShader = R"(#version 450 core
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
  vec4 shadow;
  vec4 light_position[8];
  vec4 light_colour[8];
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uint object;

layout(location = 0) out vec3 eye_position;
layout(location = 1) out vec3 eye_normal;
layout(location = 2) flat out vec4 colour_gloss;
layout(location = 3) flat out float emission;

void main() {
  vec4 p = objects[object].eye_from_mesh * vec4(position, 1.0);
  eye_position = p.xyz;
  eye_normal = mat3(objects[object].normal_x_emission.xyz, objects[object].normal_y.xyz,
                    objects[object].normal_z.xyz) * normal;
  colour_gloss = objects[object].colour_gloss;
  emission = objects[object].normal_x_emission.w;
  gl_Position = clip_from_eye * p;
}
)";

namespace {

const char* const kSceneFragmentBody = R"(
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
layout(binding = 0) uniform sampler2DShadow shadow_map;

layout(location = 0) in vec3 eye_position;
layout(location = 1) in vec3 eye_normal;
layout(location = 2) flat in vec4 colour_gloss;
layout(location = 3) flat in float emission;
layout(location = 0) out vec4 picture;

// Share of the first light that arrives, softened over two texels by the sampler. The point is moved off its surface by a
// texel and a half, and towards the light by 2 mm a metre, so that a surface does not shade itself. Depth is
// reversed: nearer to the light is greater.
float lit(vec3 normal) {
  float w = (shadow_from_eye * vec4(eye_position, 1.0)).w;
  vec4 p = shadow_from_eye * vec4(eye_position + normal * (1.5 * shadow.x * w), 1.0);
  vec2 at = p.xy / p.w;
  float seen = texture(shadow_map, vec3(at * 0.5 + 0.5, p.z / p.w * 1.002));
  return p.w <= 0.0 || any(greaterThan(abs(at), vec2(1.0))) ? 1.0 : seen;
}

// Straight up to 0.6, then a shoulder that reaches 1 at infinity: nothing clips.
vec3 tone(vec3 c) {
  vec3 over = max(c - 0.6, 0.0) / 0.4;
  return min(c, 0.6) + 0.4 * over / (1.0 + over);
}

void main() {
  vec3 n = normalize(eye_normal);
  vec3 to_eye = normalize(-eye_position);
  vec3 diffuse = mix(ground.rgb, sky.rgb, 0.5 + 0.5 * dot(n, up.xyz));
  vec3 specular = vec3(0.0);
  for (int i = 0; i < LIGHTS; ++i) {
    vec3 l = light_position[i].xyz - eye_position;
    float square = dot(l, l);
    l *= inversesqrt(square);
    float wrapped = max((dot(n, l) + 0.1) / 1.1, 0.0);
    vec3 irradiance = light_colour[i].rgb * (wrapped / (square + 0.01));
    if (i == 0 && SHADOWS) irradiance *= lit(n);
    diffuse += irradiance;
    float highlight = max(dot(n, normalize(l + to_eye)), 0.0);
    for (int squaring = 0; squaring < 5; ++squaring) highlight *= highlight;  // to the 32nd power
    specular += irradiance * highlight;
  }
  vec3 reflected = colour_gloss.rgb * diffuse + specular * (0.5 * colour_gloss.a);
  picture = vec4(tone(mix(reflected, colour_gloss.rgb, emission)), 1.0);
}
)";

}  // namespace

std::string sceneFragmentShader(std::size_t lights, bool shadows) {
  return "#version 450 core\n#define LIGHTS " + std::to_string(lights) + "\n#define SHADOWS " +
         (shadows ? "true" : "false") + kSceneFragmentBody;
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
