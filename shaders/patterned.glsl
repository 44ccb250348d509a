// Gives a point of a piece that agents wear its colour. Each pattern is bands, spots, or both, and all are computed at
// once, because a processor that draws computes both sides of a branch. A pixel has the mean of what lies in it: bands
// are integrated, and spots fade to their mean.
in vec3 second_color;
in vec3 pattern_place;       // u and v in metres; the share of trim
flat in vec4 pattern_waves;  // see cloth_patterns.glsl
flat in vec4 pattern_kind;

const float dots = 1.0, flowers = 2.0, patches = 3.0, wear = 4.0, print = 5.0, trimmed = 6.0, lines = 7.0;

// The share of a box of that width around x that lies in bands, which begin at whole numbers.
vec2 band_share(vec2 x, vec2 width, float band) {
  vec2 low = x - 0.5 * width, high = x + 0.5 * width;
  vec2 below_low = floor(low) * band + min(fract(low), band), below_high = floor(high) * band + min(fract(high), band);
  return (below_high - below_low) / width;
}

// A number of each whole place, 0 to below 1 (Hoskins, "Hash without Sine").
float chance_at(vec2 place) {
  vec3 p = fract(place.xyx * 0.1031);
  p += dot(p, p.yzx + 33.33);
  return fract((p.x + p.y) * p.z);
}

float cloud_at(vec2 place) {
  vec2 cell = floor(place), at = fract(place);
  vec2 share = at * at * (3.0 - 2.0 * at);
  float low = mix(chance_at(cell), chance_at(cell + vec2(1.0, 0.0)), share.x);
  float high = mix(chance_at(cell + vec2(0.0, 1.0)), chance_at(cell + vec2(1.0, 1.0)), share.x);
  return mix(low, high, share.y);
}

// The cosine of five times the angle of a place of that length.
float five_fold(vec2 place, float length_of_place) {
  float c = place.x / max(length_of_place, 1e-4), squared = c * c;
  return c * ((16.0 * squared - 20.0) * squared + 5.0);
}

// Jeans fade at the front of the thighs.
float worn_at_thigh(vec2 place) {
  vec2 off = (place - vec2(0.0, 0.66)) / vec2(0.055, 0.17);
  return exp2(-dot(off, off));
}

float covered(float inside, float width) { return clamp(inside / width + 0.5, 0.0, 1.0); }

vec3 patterned(vec3 first_color) {
  vec2 place = pattern_place.xy;
  float zigzag = 0.05 * abs(fract(20.0 * place.x) - 0.5);
  float lean = pattern_waves.w < 0.0 ? zigzag : pattern_waves.w * place.x;
  vec2 bands = pattern_waves.xy * vec2(place.x, place.y + lean), width = max(fwidth(bands), 1e-4);
  float share = dot(pattern_kind.xy, band_share(bands, width, pattern_waves.z));

  float kind = floor(pattern_kind.w), chance = fract(pattern_kind.w);
  vec2 spots = pattern_kind.z * place, across = fwidth(spots);
  float pixel = max(max(across.x, across.y), 1e-4), afar = smoothstep(0.5, 1.5, pixel);
  if (kind == dots) spots.x += 0.5 * mod(floor(spots.y), 2.0);
  vec2 cell = floor(spots), at = spots - cell - 0.5;
  if (kind == flowers) at += 0.3 * vec2(chance_at(cell), chance_at(cell + 31.0)) - 0.15;
  if (kind == print) at = spots;
  float reach = length(at), petals = 0.5 - 0.5 * five_fold(at.yx, reach);
  float depth = kind == flowers ? 0.55 : kind == print && chance > 0.4 ? 0.5 : 0.0;
  float radius = (kind == dots ? 0.27 : kind == print ? 0.42 : 0.38) * (1.0 - depth * petals);
  float spot = covered(radius - reach, pixel);
  if (kind == print && fract(5.0 * chance) > 0.5) spot -= covered(0.6 * radius - reach, pixel);
  if (kind == wear) spots += 40.0 * chance;
  vec2 turned_spots = mat2(0.8, 0.6, -0.6, 0.8) * spots;
  float other_cloud = cloud_at(1.7 * spots + 47.0), cloud = cloud_at(turned_spots + 0.9 * other_cloud);
  float patch_width = max(1.3 * pixel, 0.01);
  if (kind == dots) share = mix(spot, 0.23, afar);
  if (kind == flowers) share = mix(spot, 0.24, afar);
  if (kind == patches) share = mix(covered(cloud + 0.3 * other_cloud - 0.65, patch_width), 0.5, afar);
  if (kind == wear) share += 0.24 * mix(cloud, 0.5, afar) + 0.4 * worn_at_thigh(place);
  if (kind == print) share = spot;
  if (kind == trimmed) share = covered(pattern_place.z - 0.5, max(fwidth(pattern_place.z), 1e-4));
  vec3 color = mix(first_color, second_color, clamp(share, 0.0, 1.0));

  vec2 fine = band_share(bands + 0.27, width, 0.06);
  if (kind == lines) color = mix(color, vec3(0.55, 0.5, 0.4), 0.6 * max(fine.x, fine.y));
  float middle = covered(0.1 - reach, pixel) * (1.0 - afar);
  if (kind == flowers) color = mix(color, vec3(0.55, 0.36, 0.05), middle);
  float dark = covered(cloud_at(1.2 * turned_spots + 91.0 - other_cloud) - 0.62, patch_width) * (1.0 - afar);
  if (kind == patches) color *= 1.0 - 0.6 * dark;
  return color;
}
