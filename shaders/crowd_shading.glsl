// Lights a point of the crowd's surface. Include frame_uniforms.glsl and lighting.glsl before it.
in vec3 world_position;
in vec3 world_normal;
in vec4 debug_color;

vec3 facing_normal() { return normalize(gl_FrontFacing ? world_normal : -world_normal); }

// The light wraps around, because cloth and skin have no hard edge between light and shade.
float sun_share(vec3 normal) { return max((dot(normal, to_sun) + 0.25) / 1.25, 0.0); }

vec3 reflected(vec3 albedo) {
  vec3 from_eye = world_position - camera_position.xyz;
  vec3 direction = from_eye / length(from_eye);
  vec3 normal = facing_normal();
  float facing = sun_share(normal);
  float open = openness_on_body(world_position);
  vec3 light = sun_light() * (sun_visibility(world_position, normal) * facing * facing) + ambient_light(normal) * open + lamp_light(world_position, normal);

  float edge = 1.0 - max(-dot(normal, direction), 0.0);
  float rim = edge * edge * edge * (0.5 + 0.5 * normal.y);
  return albedo * light + ambient_light(normal) * (rim * 0.16);
}

// Shows light as the camera sees it: below the debug colour and through the haze.
vec3 seen(vec3 light) {
  vec3 from_eye = world_position - camera_position.xyz;
  float metres = length(from_eye);
  float facing = sun_share(facing_normal());
  vec3 color = mix(light, debug_color.rgb * (0.35 + 0.65 * facing), debug_color.a);
  return exposed(through_haze(color, from_eye / metres, metres / distance_scale));
}
