#include "render_client/draw/ShaderSources.h"

#include "render_client/compile/CompiledScene.h"

namespace coherency {
namespace {

// Positions are in the world's axes, m from a place near the eyes. In a tile of the shadow map: -1..1 across
// it twice, and height 0..1.
const char* const kView = R"(
layout(std140, binding = 0) uniform View {
  mat4 clip_from_world;
  mat4 shadow_from_world;  // to the first tile of the shadow map
  vec4 to_second_tile;     // from the first
  vec4 eye;
  vec4 sky;
  vec4 ground;
};

// 0 in a tile's middle, 1 at its border.
float offTile(vec3 at) { return max(abs(at.x), abs(at.y)); }
vec3 inTexture(vec3 at, bool second) {
  return TWO_TILES ? vec3(at.xy * vec2(0.25, 0.5) + vec2(second ? 0.75 : 0.25, 0.5), at.z)
                   : vec3(at.xy * 0.5 + 0.5, at.z);
}
)";

const char* const kVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 2) in uint object;

#if IDS
layout(location = 3) flat out uint number;
#endif
#if MAPPED
layout(location = 0) out vec2 place;            // in the lightmap
layout(location = 2) flat out vec4 colour;     // and emission
#else
layout(location = 0) out vec3 light;      // that the surface sends to the eye where nothing moves above it
#endif
layout(location = 1) out vec4 shadow_at;  // in the map, or its first tile; share of light that what moves above keeps away

vec3 inShadowMap(vec3 p) { return (shadow_from_world * vec4(p, 1.0)).xyz; }
)";

const char* const kFixedVertex = R"(
layout(std430, binding = 0) readonly buffer Offsets { vec4 offsets[]; };  // of blocks
layout(location = 1) in vec4 baked;     // place in the lightmap, or as its texels are
layout(location = 3) in vec4 material;  // roots of the colour, and emission

void main() {
  vec3 p = offsets[object].xyz + position;
  gl_Position = clip_from_world * vec4(p, 1.0);
#if IDS
  number = object;
#endif
  float share = 1.0 - material.a;
#if MAPPED
  place = baked.xy;
  colour = vec4(material.rgb * material.rgb, material.a);
#else
  light = material.rgb * material.rgb * mix(BRIGHTEST * baked.rgb, vec3(1.0), material.a);
  share *= baked.a;
#endif
  if (SHADOWS) shadow_at = vec4(inShadowMap(p), share);
}
)";

// Falloff: compile/Illumination.h has the same. Shadows fall on what faces the light they are cast along
// only, and fully on what is level. As they are soft, and heights are those of a map's texels, they begin a
// little above the surface, and the more so the steeper it is to that light.
const char* const kMovingVertex = R"(
struct Object {
  mat4 world_from_mesh;
  vec4 normal_x_emission;
  vec4 normal_y;
  vec4 normal_z;
  vec4 colour_gloss;
  vec4 place_root;  // for which its lamps were chosen, and the number of their set
};
struct Lamp {
  vec4 position_reach;  // m, from that place
  vec4 colour;          // irradiance at 1 m
};
struct LampSet {
  vec4 others;  // irradiance from above of those not chosen
  Lamp lamps[4];
};
layout(std430, binding = 0) readonly buffer Objects { Object objects[]; };
layout(std430, binding = 1) readonly buffer LampSets { LampSet lamp_sets[]; };
layout(location = 1) in vec3 normal;

float falloff(float square, float reach) {
  float x = square / (reach * reach);
  float fade = max(1.0 - x * x, 0.0);
  return fade * fade / max(square, 0.25);
}

void main() {
  vec3 p = (objects[object].world_from_mesh * vec4(position, 1.0)).xyz;
  gl_Position = clip_from_world * vec4(p, 1.0);
#if IDS
  number = object;
#endif
  vec3 n = normalize(mat3(objects[object].normal_x_emission.xyz, objects[object].normal_y.xyz,
                          objects[object].normal_z.xyz) * normal);
  vec3 to_eye = normalize(eye.xyz - p);
  vec3 colour = objects[object].colour_gloss.rgb;
  float gloss = 0.5 * objects[object].colour_gloss.a;
  float emission = objects[object].normal_x_emission.w;

  uint set = uint(objects[object].place_root.w);
  vec3 from_place = p - objects[object].place_root.xyz;
  vec3 irradiance = mix(ground.rgb, sky.rgb + lamp_sets[set].others.rgb, 0.5 + 0.5 * n.y);
  vec3 overhead = AMBIENT_SHADE * irradiance;
  vec3 highlights = vec3(0.0);
  for (int i = 0; i < LAMPS; ++i) {
    vec4 position_reach = lamp_sets[set].lamps[i].position_reach;
    vec3 l = position_reach.xyz - from_place;
    float square = dot(l, l);
    l *= inversesqrt(square);
    vec3 reaching = lamp_sets[set].lamps[i].colour.rgb *
                    (falloff(square, position_reach.w) * max((dot(n, l) + 0.1) / 1.1, 0.0));
    float highlight = max(dot(n, normalize(l + to_eye)), 0.0);
    for (int squaring = 0; squaring < 5; ++squaring) highlight *= highlight;  // to the 32nd power
    irradiance += reaching;
    overhead += reaching * max(l.y, 0.0);
    highlights += reaching * highlight;
  }
  light = mix(colour * irradiance + gloss * highlights, colour, emission);
  if (SHADOWS) {
    const vec3 brightness = vec3(0.2126, 0.7152, 0.0722);
    float facing = max(dot(n, TO_SHADOW_LIGHT), 0.0);  // 1 for what is level
    float share = min(facing, 1.0) * dot(overhead, brightness) / max(dot(irradiance, brightness), 1e-6);
    float rise = length(n.xz) / max(facing, 0.25);     // along the light, for each m across it
    // All of a whole is looked up in one tile, and it is lit again before a triangle that begins in it ends beyond it.
    vec3 at = inShadowMap(p + vec3(0.0, 0.002 + 2.0 * TEXEL * TILE_WIDTH * rise, 0.0));
    vec3 middle = inShadowMap(objects[object].place_root.xyz);
    bool second = TWO_TILES && offTile(middle + to_second_tile.xyz) < offTile(middle);
    at = second ? at + to_second_tile.xyz : at;
    float fade = clamp(3.75 - 5.0 * offTile(at), 0.0, 1.0);
    shadow_at = vec4(inTexture(at, second), fade * share * (1.0 - emission));
  }
}
)";

const char* const kFragment = R"(
layout(binding = 0) uniform sampler2DShadow shadow_map;
#if MAPPED
layout(binding = 1) uniform sampler2D lightmap;  // irradiance / BRIGHTEST, and the share for shadow_at
layout(location = 0) in vec2 place;
layout(location = 2) flat in vec4 colour;
#else
layout(location = 0) in vec3 light;
#endif
layout(location = 1) in vec4 shadow_at;
layout(location = 0) out vec4 picture;

// Straight up to a half, then a shoulder that reaches 1 at infinity: nothing clips. compile/ToneCurve.h has the same. No
// choice between vectors here: on a software renderer one costs as much as all the rest.
vec3 tone(vec3 c) { return min(c, 0.5) + 0.5 - 0.25 / max(c, 0.5); }

// As sRGB, to 0.09 % of white. compile/ToneCurve.h has the same. Done here it is done once a pixel; left to the target, a
// software renderer does it for every sample, which costs an eighth of the frame. One root: three cost a tenth.
vec3 encoded(vec3 c) {
  vec3 r = sqrt(c);
  vec3 curve = (((-0.311395113 * r + 0.846885902) * r - 0.947945999) * r + 1.448778461) * r - 0.037078028;
  return max(curve, min(12.92 * c, 0.04045));
}

// One lookup, which takes in two by two texels: on a software renderer a second one costs a tenth of the frame. Of what
// never moves each pixel looks in the tile in whose border it is less.
float shadow() {
  vec3 at = shadow_at.xyz;
  float share = shadow_at.w;
  if (FIXED) {
    vec3 in_second = TWO_TILES ? at + to_second_tile.xyz : at;
    float off_first = offTile(at);
    float off_second = offTile(in_second);
    share *= clamp(5.0 - 5.0 * min(off_first, off_second), 0.0, 1.0);
    at = inTexture(off_first <= off_second ? at : in_second, off_first > off_second);
  }
  return share * (1.0 - texture(shadow_map, at));
}

void main() {
#if MAPPED
  vec4 baked = texture(lightmap, place);
  vec3 light = colour.rgb * mix(BRIGHTEST * baked.rgb, vec3(1.0), colour.a);
  float share = baked.a;
#else
  float share = 1.0;
#endif
  picture = vec4(encoded(tone(SHADOWS ? light * (1.0 - share * shadow()) : light)), 1.0);
}
)";

const char* const kIdFragment = R"(
layout(location = 3) flat in uint number;  // of the draw command
layout(location = 0) out uvec4 drawn;
void main() { drawn = uvec4(LIGHT_SOURCE + 1, number, gl_PrimitiveID, 0); }
)";

std::string defined(const ShaderVariant& variant) {
  const bool shadows = variant.shadows.resolution > 0;
  return "#version 450 core\n#define FIXED " +
         std::string(variant.light == LightSource::Lamps ? "false" : "true") + "\n#define MAPPED " +
         (variant.light == LightSource::Lightmap ? "1" : "0") + "\n#define IDS " + (variant.ids ? "1" : "0") +
         "\n#define LIGHT_SOURCE " + std::to_string(static_cast<int>(variant.light)) + "\n#define LAMPS " +
         std::to_string(variant.lamps) + "\n#define SHADOWS " + (shadows ? "true" : "false") +
         "\n#define TEXEL " + std::to_string(shadows ? 1.0 / variant.shadows.resolution : 0.0) +
         "\n#define TWO_TILES " + (variant.shadows.tiles == 2 ? "true" : "false") + "\n#define BRIGHTEST " +
         std::to_string(PackedLight::kBrightest) + "\n#define AMBIENT_SHADE " +
         std::to_string(kAmbientShade) + "\n#define TILE_WIDTH " + std::to_string(kShadowTileWidth) +
         "\n#define TO_SHADOW_LIGHT vec3(" + std::to_string(-kShadowLean.x) + ", 1.0, " +
         std::to_string(-kShadowLean.y) + ")\n";
}

}  // namespace

std::string fixedVertexShader(const ShaderVariant& variant) {
  return defined(variant) + kView + kVertex + kFixedVertex;
}

std::string movingVertexShader(const ShaderVariant& variant) {
  return defined(variant) + kView + kVertex + kMovingVertex;
}

std::string fragmentShader(const ShaderVariant& variant) {
  return defined(variant) + (variant.ids ? kIdFragment : std::string(kView) + kFragment);
}

const char* const kShadowVertexShader = R"(#version 450 core
layout(std430, binding = 0) readonly buffer Objects { mat4 map_from_mesh[]; };
layout(location = 0) in vec3 position;
layout(location = 2) in uint object;
void main() { gl_Position = map_from_mesh[object] * vec4(position, 1.0); }
)";

const char* const kShadowFragmentShader = R"(#version 450 core
void main() {}
)";

const char* const kTextVertexShader = R"(#version 450 core
layout(location = 0) uniform mat3 clip_from_text;
layout(location = 0) in vec2 position;  // dots from the text's top left corner
void main() {
  vec3 at = clip_from_text * vec3(position, 1.0);
  gl_Position = vec4(at.xy, 0.0, at.z);
}
)";

const char* const kTextFragmentShader = R"(#version 450 core
layout(location = 1) uniform vec4 colour;
layout(location = 0) out vec4 picture;
void main() { picture = colour; }
)";

}  // namespace coherency
