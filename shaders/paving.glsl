// Covers the plane y = 0: slabs of stone, a street, or a pitch, by engine/render/scene_ground.h. All is filtered over
// `footprint`, the metres of ground that a pixel covers.
const vec3 stone_color = vec3(0.225, 0.205, 0.180);
const vec3 joint_color = vec3(0.085, 0.080, 0.075);
const vec3 inlay_color = vec3(0.35, 0.325, 0.285);

const vec2 slab_size = vec2(1.5, 0.75);  // metres
const float joint_width = 0.022;
const float inlay_spacing = 12.0;
const float inlay_width = 0.30;

// Gives the share, 0 to 1, of [x - width / 2, x + width / 2] that lies within `thickness` after a whole number.
float band_share(float x, float thickness, float width) {
  float low = x - width * 0.5, high = x + width * 0.5;
  float low_covered = floor(low) * thickness + min(fract(low), thickness);
  float high_covered = floor(high) * thickness + min(fract(high), thickness);
  return (high_covered - low_covered) / width;
}

float random_of(vec2 cell) { return fract(sin(dot(cell, vec2(12.9898, 78.233))) * 43758.5453); }

float smooth_noise(vec2 place) {
  vec2 cell = floor(place), f = fract(place);
  f = f * f * (3.0 - 2.0 * f);
  float low = mix(random_of(cell), random_of(cell + vec2(1.0, 0.0)), f.x);
  float high = mix(random_of(cell + vec2(0.0, 1.0)), random_of(cell + vec2(1.0, 1.0)), f.x);
  return mix(low, high, f.y);
}

// Gives the distance from the loop that the shape describes: negative inside.
float loop_distance(vec2 ground, float radius) {
  vec2 beyond = abs(ground) - ground_shape.xy / ground_unit;
  return length(max(beyond, vec2(0.0))) + min(max(beyond.x, beyond.y), 0.0) - radius;
}

vec3 slabs(vec2 ground, vec2 footprint) {
  vec2 width = max(footprint / slab_size, vec2(1e-4));
  vec2 slab = ground / slab_size;
  // Every other row is shifted by half a slab.
  slab.x += 0.5 * mod(floor(slab.y), 2.0);
  vec2 joints = vec2(band_share(slab.x, joint_width / slab_size.x, width.x),
                     band_share(slab.y, joint_width / slab_size.y, width.y));
  float joint = 1.0 - (1.0 - joints.x) * (1.0 - joints.y);

  // Slabs differ in tone as long as a pixel does not hold several of them.
  float distinct = clamp(1.0 - max(width.x, width.y) * 1.5, 0.0, 1.0);
  float tone = 1.0 + distinct * 0.20 * (random_of(floor(slab)) - 0.5);
  tone += 0.16 * (smooth_noise(ground * 0.11) - 0.5);

  float inlay = 0.0;
#ifndef STREET
  if (ground_is_endless || loop_distance(ground, 0.0) < 0.0) {
    float ring = length(ground) / inlay_spacing + 0.5;
    float ring_width = max(max(footprint.x, footprint.y) / inlay_spacing, 1e-4);
    inlay = band_share(ring, inlay_width / inlay_spacing, ring_width);
  }
#endif
  vec3 stone = mix(stone_color, inlay_color, inlay) * tone;
  return mix(stone, joint_color, joint * (1.0 - 0.6 * inlay));
}

const vec3 asphalt_color = vec3(0.062, 0.062, 0.066);
const vec3 kerb_color = vec3(0.30, 0.29, 0.27);
const vec3 line_color = vec3(0.62, 0.61, 0.58);
const vec3 grass_color = vec3(0.060, 0.125, 0.028);
const vec3 track_color = vec3(0.255, 0.070, 0.040);
const vec3 concrete_color = vec3(0.20, 0.195, 0.185);

const float kerb_width = 0.30;  // metres
const float line_width = 0.12;
const float mown_stripe = 5.5;

// Gives the share, 0 to 1, of a pixel that lies within `half_width` of the place where `distance` is 0.
float stroke(float distance, float half_width, float footprint) {
  float low = max(distance - 0.5 * footprint, -half_width), high = min(distance + 0.5 * footprint, half_width);
  return clamp((high - low) / footprint, 0.0, 1.0);
}

// Gives the share of a pixel where `distance` is below 0.
float inside(float distance, float footprint) { return clamp(0.5 - distance / footprint, 0.0, 1.0); }

vec3 asphalt(vec2 ground, float wide) {
  float grain = 0.30 * (smooth_noise(ground * 37.0) - 0.5) * clamp(1.0 - wide * 30.0, 0.0, 1.0);
  return asphalt_color * (1.0 + grain + 0.35 * (smooth_noise(ground * 0.23) - 0.5));
}

vec3 street(vec2 ground, vec2 footprint) {
  float wide = max(max(footprint.x, footprint.y), 1e-4);
  float half_width = ground_shape.w / ground_unit;
  float across = abs(loop_distance(ground, ground_shape.z / ground_unit)) - half_width;
  vec3 color = slabs(ground, footprint);
  if (across < wide) color = mix(color, asphalt(ground, wide), inside(across, wide));
  return mix(color, kerb_color, stroke(across - 0.5 * kerb_width, 0.5 * kerb_width, wide));
}

// Draws a line along the edges of a rectangle about `middle`.
float frame_line(vec2 ground, vec2 middle, vec2 half_sides, float wide) {
  vec2 beyond = abs(ground - middle) - half_sides;
  float outside = length(max(beyond, vec2(0.0))) + min(max(beyond.x, beyond.y), 0.0);
  return stroke(outside, 0.5 * line_width, wide);
}

// Marks a football field whose half sides are those of the grass.
float field_lines(vec2 ground, vec2 half_sides, float wide) {
  vec2 side = vec2(abs(ground.x), ground.y);
  float scale = min(half_sides.x / 52.5, half_sides.y / 34.0);
  float lines = frame_line(ground, vec2(0.0), half_sides, wide);
  if (abs(ground.x) > half_sides.x || abs(ground.y) > half_sides.y) return lines;
  lines = max(lines, stroke(ground.x, 0.5 * line_width, wide));
  lines = max(lines, stroke(length(ground) - 9.15 * scale, 0.5 * line_width, wide));
  lines = max(lines, inside(length(ground) - 0.35 * scale, wide));
  lines = max(lines, frame_line(side, vec2(half_sides.x, 0.0), vec2(16.5, 20.16) * scale, wide));
  return max(lines, frame_line(side, vec2(half_sides.x, 0.0), vec2(5.5, 9.16) * scale, wide));
}

vec3 pitch(vec2 ground, vec2 footprint) {
  float wide = max(max(footprint.x, footprint.y), 1e-4);
  float track = ground_shape.w / ground_unit;
  float outside = loop_distance(ground, ground_shape.z / ground_unit);  // of the track
  float edge = outside + track;                                         // of the grass
  vec3 color = concrete_color * (1.0 + 0.18 * (smooth_noise(ground * 0.4) - 0.5));
  if (outside < wide) {
    float lanes = band_share(-outside / 1.25, line_width * 0.6, max(wide / 1.25, 1e-4));
    vec3 rubber = mix(track_color * (1.0 + 0.15 * (smooth_noise(ground * 0.8) - 0.5)), line_color, lanes * 0.8);
    color = mix(color, rubber, inside(outside, wide));
  }
  if (edge >= wide) return color;
  vec2 half_sides = (ground_shape.xy + ground_shape.z) / ground_unit - track - 1.2;
  float mown = band_share(ground.x / (2.0 * mown_stripe), 0.5, max(footprint.x / (2.0 * mown_stripe), 1e-4));
  float tuft = (smooth_noise(ground * 6.0) - 0.5) * clamp(1.0 - wide * 4.0, 0.0, 1.0);
  vec3 grass = grass_color * (0.92 + 0.26 * mown + 0.30 * tuft + 0.25 * (smooth_noise(ground * 0.15) - 0.5));
  grass = mix(grass, line_color, field_lines(ground, half_sides, wide));
  return mix(color, grass, inside(edge, wide));
}

// Gives meadows and fields, each of a colour of its own.
vec3 fields(vec2 ground, float wide) {
  vec2 field = floor((ground + 25.0 * smooth_noise(ground * 0.01)) / vec2(95.0, 70.0));
  vec3 color = mix(vec3(0.075, 0.125, 0.030), vec3(0.165, 0.150, 0.045), random_of(field));
  return color * (0.9 + 0.3 * (smooth_noise(ground * 0.07) - 0.5) + 0.25 * (smooth_noise(ground * 1.3) - 0.5) *
                                                                      clamp(1.0 - wide, 0.0, 1.0));
}

// Gives the colour of the ground, filtered over `footprint`. Include frame_uniforms.glsl before.
vec3 paving(vec2 metres, vec2 metres_a_pixel) {
  vec2 ground = metres / ground_unit, footprint = metres_a_pixel / ground_unit;
#if defined(FIELDS)
  return fields(ground, max(max(footprint.x, footprint.y), 1e-4));
#elif defined(STREET)
  return street(ground, footprint);
#elif defined(PITCH)
  return pitch(ground, footprint);
#else
  return slabs(ground, footprint);
#endif
}
