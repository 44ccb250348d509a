// Converts sRGB to linear, closely enough for colours that a person picked.
vec3 to_linear(vec3 srgb) { return srgb * (srgb * (srgb * 0.305306011 + 0.682171111) + 0.012522878); }

// Converts back, within 0.003.
vec3 to_srgb(vec3 linear) {
  vec3 half_power = sqrt(linear), quarter = sqrt(half_power);
  return clamp(0.585122381 * half_power + 0.783140355 * quarter - 0.368262736 * sqrt(quarter), 0.0, 1.0);
}
