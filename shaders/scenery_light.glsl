// Lights what stands around the crowd. Include frame_uniforms.glsl before it.
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 albedo;
in vec3 light_around;  // what a white surface reflects of the sky, or sends out at night
in vec3 haze_before;
in vec3 clear_share;  // that the haze leaves of what is behind it

// Gives the light that a surface scatters and sends out.
vec3 scattered(vec3 normal) {
  float lit = max(dot(normal, to_sun), 0.0);
#ifdef SHADOWS
  lit *= sun_visibility(world_position, normal);
#endif
  return albedo * (sun_light() * lit + light_around + lamp_light(world_position, normal));
}

vec3 facing_normal() { return normalize(gl_FrontFacing ? world_normal : -world_normal); }

vec4 seen_from_camera(vec3 light) { return vec4(exposed(light * clear_share + haze_before), 1.0); }
