// Looks up the patterns and fabrics of a look, for the vertices of pieces that agents wear. Include agent_look.glsl
// before it. The fragment's side is patterned.glsl and fabrics.glsl.

uint pattern_of(uint tint) { return min(tint >> 24 & 31u, 12u); }
uint fabric_of(uint tint) { return tint >> 29; }

// The share of the second colour in all of a pattern, for those so far away that it is too small to be seen.
const float mean_of_pattern[13] = float[](0.0, 0.5, 0.14, 0.5, 0.45, 0.23, 0.27, 0.04, 0.0, 0.0, 0.24, 0.5, 0.35);
const uint denim_pattern = 6u, print_pattern = 7u, trim_pattern = 8u, blocks_pattern = 9u;
const float middle_of_chest = 1.30, lower_end_of_block = 1.20;  // metres

float mean_share(uint pattern) {
  if (pattern == trim_pattern) return trim;
  if (pattern == blocks_pattern) return texture_coord.y > lower_end_of_block ? 1.0 : 0.0;
  return mean_of_pattern[pattern];
}

#ifdef DRESSED
// Bands: how many a metre lie across u and across v; the share of each that has the second colour; how far those across
// v lean, -1: they zigzag.
const vec4 waves_of_pattern[13] = vec4[](
    vec4(1.0, 1.0, 0.0, 0.0), vec4(1.0, 14.0, 0.5, 0.0), vec4(45.0, 1.0, 0.14, 0.0), vec4(36.0, 36.0, 0.5, 0.0),
    vec4(9.0, 9.0, 0.45, 0.0), vec4(1.0, 1.0, 0.0, 0.0), vec4(1.0, 360.0, 0.5, 1.0), vec4(1.0, 1.0, 0.0, 0.0),
    vec4(1.0, 1.0, 0.0, 0.0), vec4(1.0, 0.25, 0.5, 0.0), vec4(1.0, 1.0, 0.0, 0.0), vec4(1.0, 1.0, 0.0, 0.0),
    vec4(1.0, 62.0, 0.5, -1.0));
// A pattern has four numbers: how much bands across u show, and bands across v; spots a metre; the kind of spots
// (patterned.glsl).
const vec4 kind_of_pattern[13] = vec4[](
    vec4(0.0, 0.0, 1.0, 0.0), vec4(0.0, 1.0, 1.0, 0.0), vec4(1.0, 0.0, 1.0, 0.0), vec4(0.5, 0.5, 1.0, 0.0),
    vec4(0.5, 0.5, 1.0, 7.0), vec4(0.0, 0.0, 22.0, 1.0), vec4(0.0, 0.22, 7.0, 4.0), vec4(0.0, 0.0, 5.0, 5.0),
    vec4(0.0, 0.0, 1.0, 6.0), vec4(0.0, 1.0, 1.0, 0.0), vec4(0.0, 0.0, 13.0, 2.0), vec4(0.0, 0.0, 13.0, 3.0),
    vec4(0.0, 0.7, 1.0, 0.0));
// A fabric has four numbers: how softly the edge shines; how much it mirrors; how tightly; how little its light depends
// on the sun's direction.
const vec4 light_of_fabric[8] = vec4[](vec4(0.0, 0.0, 1.0, 0.0), vec4(0.2, 0.0, 1.0, 0.45), vec4(1.0, 0.0, 1.0, 0.3),
                                       vec4(0.15, 0.42, 8.0, 0.0), vec4(0.0, 0.34, 13.0, 0.0),
                                       vec4(0.05, 0.22, 6.0, 0.0), vec4(0.06, 0.07, 5.0, 0.1),
                                       vec4(0.0, 0.55, 24.0, 0.0));

out vec3 second_color;
out vec3 pattern_place;  // u and v in metres; the share of trim
out vec3 way_to_eye;
flat out vec4 pattern_waves;
flat out vec4 pattern_kind;
flat out vec4 fabric_light;

// Four numbers of an agent, 0 to 1.
vec4 chances_of(uint agent) {
  uvec4 bits = (agent + 1u) * uvec4(2654435761u, 2246822519u, 3266489917u, 668265263u);
  bits = (bits ^ (bits >> 15)) * 2246822519u;
  return vec4(bits >> 8) * (1.0 / 16777216.0);
}

// No two agents have their pattern at the same place and quite as large.
void lay_pattern(uint agent, uint tint, uint second) {
  uint pattern = pattern_of(tint);
  vec4 chances = chances_of(agent + 7919u * region);
  float size = max(float(second >> 24), 16.0) / 128.0 * (0.9 + 0.2 * chances.z);
  pattern_waves = waves_of_pattern[pattern];
  pattern_kind = kind_of_pattern[pattern];
  pattern_place = vec3(texture_coord, trim);
  fabric_light = light_of_fabric[fabric_of(tint)];
  if (pattern == print_pattern) {
    pattern_place.y -= middle_of_chest;
  } else if (pattern == blocks_pattern) {
    pattern_place.y -= lower_end_of_block;
    size = 1.0;
  } else if (pattern != denim_pattern) {
    pattern_place.xy += 4.0 * chances.xy;
  }
  pattern_waves.xy /= size;
  pattern_kind.z /= size;
  pattern_kind.w += 0.98 * chances.w;
}
#endif
