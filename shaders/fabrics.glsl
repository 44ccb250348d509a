// Lights a piece that agents wear as its fabric does: wool shines softly at its edge, satin, leather and plastic mirror
// the sun tightly, and coarse cloth looks much the same from everywhere. Include sun_on_cloth.glsl before it.
in vec3 way_to_eye;
flat in vec4 fabric_light;  // see cloth_patterns.glsl

// The share of the sun's light that a fabric scatters.
float scattered_of_sun(float facing) { return mix(facing * facing, 0.85 * facing, fabric_light.w); }

// Returns the light that shines over that; a white surface reflects `sun` and `around`. Schlick's power, squared here,
// has no logarithm (1994, "An Inexpensive BRDF Model").
vec3 shine(vec3 normal, vec3 albedo, vec3 sun, vec3 around) {
  vec3 to_eye = normalize(way_to_eye);
  float edge = 1.0 - max(dot(normal, to_eye), 0.0), squared = edge * edge;
  float half_way = max(dot(normal, normalize(to_sun + to_eye)), 0.0);
  float mirrored = half_way / (fabric_light.z - fabric_light.z * half_way + half_way);
  vec3 soft = fabric_light.x * edge * squared * (0.6 * albedo + 0.02) * (sun + around);
  return soft + fabric_light.y * (mirrored * mirrored * sun + (0.015 + 0.5 * squared * squared) * around);
}
