// Shows a point of the crowd's surface that has a material. Include frame_uniforms.glsl and lighting.glsl before it.
in vec3 world_position;
in vec3 world_normal;
#ifdef DEBUG_COLORS
in vec4 debug_color;
#endif

#include "sun_on_cloth.glsl"

vec3 facing_normal() { return normalize(gl_FrontFacing ? world_normal : -world_normal); }

// Shows light as the camera sees it: below the debug colour and through the haze.
vec3 seen(vec3 light) {
  vec3 from_eye = world_position - camera_position.xyz;
  float metres = length(from_eye);
#ifdef DEBUG_COLORS
  light = below(debug_color, sun_share(facing_normal()), light);
#endif
  return exposed(through_haze(light, from_eye / metres, metres / distance_scale));
}
