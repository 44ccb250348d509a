// Gives what a white surface reflects of the lamps around. Include light_uniforms.glsl and shadows.glsl before it.
#ifdef LAMPS
layout(binding = 12) uniform sampler2D lamp_map;
#endif

vec3 lamp_light(vec3 position, vec3 normal) {
#ifdef LAMPS
  vec3 light = texture(lamp_map, (position.xz - lamp_map_place.xy) * lamp_map_place.z).rgb;
  light /= 1.0 + 0.45 * brightest(light);  // who stands below floodlights gets used to them
  // Lamps hang above people, on all sides of them.
  float share = (0.62 + 0.38 * normal.y) * clamp(2.0 - 2.0 * position.y / lamp_map_place.w, 0.0, 1.0);
  return light * (night_share * share);
#else
  return vec3(0.0);
#endif
}
