// Paves the plane y = 0 with stone slabs, filtered over `footprint`, the metres of ground that a pixel covers.
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

vec3 paving(vec2 ground, vec2 footprint) {
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

  float ring = length(ground) / inlay_spacing + 0.5;
  float ring_width = max(max(footprint.x, footprint.y) / inlay_spacing, 1e-4);
  float inlay = band_share(ring, inlay_width / inlay_spacing, ring_width);
  vec3 stone = mix(stone_color, inlay_color, inlay) * tone;
  return mix(stone, joint_color, joint * (1.0 - 0.6 * inlay));
}
