// Says how much of the sun and of the sky reaches a place. Include light_uniforms.glsl before it. Its parts are in
// programs with the switches SHADOWS and CROWD_SHADE alone (engine/render/light/light_parts.h).
#include "shadow_uniforms.glsl"

#ifdef SHADOWS
layout(binding = 8) uniform sampler2DArrayShadow shadow_maps;

float lit_share_at(vec2 place, int cascade, float depth) {
  return texture(shadow_maps, vec4(place, float(cascade), depth));
}

// Averages 5x5 texels with nine filtered reads (Castano, "Shadow Mapping Summary", 2013).
float lit_share(vec3 place, int cascade) {
  float side = float(textureSize(shadow_maps, 0).x);
  vec2 at = place.xy * side;
  vec2 base = floor(at + 0.5);
  vec2 s = at + 0.5 - base;
  base = (base - 0.5) / side;
  vec2 w0 = 4.0 - 3.0 * s, w1 = vec2(7.0), w2 = 1.0 + 3.0 * s;
  vec2 p0 = ((3.0 - 2.0 * s) / w0 - 2.0) / side, p1 = ((3.0 + s) / w1) / side, p2 = (s / w2 + 2.0) / side;
  float sum = w0.x * w0.y * lit_share_at(base + p0, cascade, place.z) +
              w1.x * w0.y * lit_share_at(base + vec2(p1.x, p0.y), cascade, place.z) +
              w2.x * w0.y * lit_share_at(base + vec2(p2.x, p0.y), cascade, place.z);
  sum += w0.x * w1.y * lit_share_at(base + vec2(p0.x, p1.y), cascade, place.z) +
         w1.x * w1.y * lit_share_at(base + p1, cascade, place.z) +
         w2.x * w1.y * lit_share_at(base + vec2(p2.x, p1.y), cascade, place.z);
  sum += w0.x * w2.y * lit_share_at(base + vec2(p0.x, p2.y), cascade, place.z) +
         w1.x * w2.y * lit_share_at(base + vec2(p1.x, p2.y), cascade, place.z) +
         w2.x * w2.y * lit_share_at(base + p2, cascade, place.z);
  return sum / 144.0;
}

// Reads a cascade a little outside of the surface, so that nothing shades itself by the size of a texel.
float lit_share_in(int cascade, vec3 position, vec3 normal) {
  float texel = cascade_texel[cascade];
  float facing = clamp(dot(normal, to_sun), 0.0, 1.0);
  vec3 outside = position + texel * (normal * (0.6 + 1.9 * sqrt(1.0 - facing * facing)) + 0.5 * to_sun);
  return lit_share((cascade_to_map[cascade] * vec4(outside, 1.0)).xyz, cascade);
}

#endif

// Gives 0 in shadow and 1 in the sun. Where a cascade ends, the next one takes over little by little.
float sun_visibility(vec3 position, vec3 normal) {
#ifdef SHADOWS
  float depth = dot(depth_of_place, vec4(position, 1.0));
  int cascade = int(depth > cascade_reach.x) + int(depth > cascade_reach.y) + int(depth > cascade_reach.z);
  float reach = cascade_reach[cascade];
  if (depth > cascade_reach.w) return 1.0;
  float lit = lit_share_in(cascade, position, normal);
  float leaving = clamp((depth / reach - 0.9) * 10.0, 0.0, 1.0);
  if (leaving == 0.0) return lit;
  return mix(lit, cascade < 3 ? lit_share_in(cascade + 1, position, normal) : 1.0, leaving);
#else
  return 1.0;
#endif
}

#ifdef CROWD_SHADE
layout(binding = 11) uniform sampler2D crowd_map;  // people a square metre

// Gives the share of the sky that a crowd of so many people a square metre leaves at a height in metres: bodies are
// cylinders that stand at random, so a ray towards the elevation e goes free with exp(-crowding * cot(e)). The average
// over the sky, weighed by the cosine, is within 0.03 of this (CrowdShade in tests/gl).
const float body_width = 0.44, body_height = 1.7;  // metres

float sky_share(float people, float height) {
  float crowding = people * body_width * max(body_height - height, 0.0);
  return 1.0 / (1.0 + crowding * (1.57 + 0.15 * crowding));
}

float people_at(vec3 position) {
  return texture(crowd_map, (position.xz - crowd_map_place.xy) * crowd_map_place.z).r;
}

#endif

// Gives how much of the sky the crowd around a place leaves, 0 to 1.
float openness(vec3 position) {
#ifdef CROWD_SHADE
  return sky_share(people_at(position), position.y);
#else
  return 1.0;
#endif
}

// Does the same for a place on a body, which does not count itself.
float openness_on_body(vec3 position) {
#ifdef CROWD_SHADE
  return sky_share(max(people_at(position) - crowd_map_place.w, 0.0), position.y);
#else
  // Feet see less of the sky than heads, because a crowd surrounds them as a rule.
  return 0.62 + 0.38 * smoothstep(0.0, 1.1, position.y);
#endif
}
