// Lights what stands around the crowd. Include frame_uniforms.glsl before it.
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 albedo;
in float glow;

const float glow_light = 2.2;

// Gives the light that a surface scatters and sends out.
vec3 scattered(vec3 normal) {
  float facing = max(dot(normal, to_sun), 0.0);
  if (facing > 0.0) facing *= sun_visibility(world_position, normal);
  vec3 light = sun_light() * facing + ambient_light(normal) * openness(world_position) +
               lamp_light(world_position, normal) + glow * night() * glow_light;
  return albedo * light;
}

vec3 facing_normal() { return normalize(gl_FrontFacing ? world_normal : -world_normal); }

vec4 seen_from_camera(vec3 light, vec3 from_eye) {
  float metres = length(from_eye);
  return vec4(exposed(through_haze(light, from_eye / metres, metres / distance_scale)), 1.0);
}
