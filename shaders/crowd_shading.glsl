// Computes the colour of a point of the crowd's surface. Include frame_uniforms.glsl and lighting.glsl before it.
layout(binding = 0) uniform sampler2D base_color_texture;

layout(location = 1) uniform vec4 base_color;

in vec3 world_position;
in vec3 world_normal;
in vec2 passed_texture_coord;
in vec4 passed_color;
flat in vec4 debug_color;

vec4 surface_color() { return base_color * passed_color * texture(base_color_texture, passed_texture_coord); }

vec3 shaded(vec3 albedo) {
  vec3 from_eye = world_position - camera_position.xyz;
  float metres = length(from_eye);
  vec3 direction = from_eye / metres;
  vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);

  // The light wraps around, because cloth and skin have no hard edge between light and shade.
  float facing = max((dot(normal, to_sun) + 0.25) / 1.25, 0.0);
  // Feet see less of the sky than heads, because a crowd and the ground surround them.
  float openness = 0.62 + 0.38 * smoothstep(0.0, 1.1, world_position.y);
  vec3 light = sun_light * (facing * facing) + ambient_light(normal) * openness;

  float edge = 1.0 - max(-dot(normal, direction), 0.0);
  float rim = edge * edge * edge * (0.5 + 0.5 * normal.y);
  vec3 color = albedo * light + sky_light * (rim * 0.16);
  return exposed(through_haze(mix(color, debug_color.rgb * (0.35 + 0.65 * facing), debug_color.a), direction, metres));
}
