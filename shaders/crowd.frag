#version 450 core

#include "frame_uniforms.glsl"
#include "lighting.glsl"
#include "shadows.glsl"
#include "sun_on_cloth.glsl"

layout(location = 1) uniform vec4 base_color;

in vec3 world_normal;
in vec3 passed_color;
in vec4 light_around;
in vec4 haze_before;
#ifdef SHADOWS
in vec3 world_position;
#endif
#ifdef TEXTURED
layout(binding = 0) uniform sampler2D base_color_texture;
in vec2 passed_texture_coord;
#endif
#ifdef DEBUG_COLORS
in vec4 debug_color;
#endif
#ifdef DRESSED
#include "patterned.glsl"
#include "fabrics.glsl"
#endif

out vec4 color;

void main() {
  vec3 normal = normalize(world_normal);
#ifdef DRESSED
  if (!gl_FrontFacing) normal = -normal;
  vec3 albedo = base_color.rgb * patterned(passed_color);
#else
  vec3 albedo = base_color.rgb * passed_color;
#endif
#ifdef TEXTURED
  albedo *= texture(base_color_texture, passed_texture_coord).rgb;
#endif
  float facing = sun_share(normal);
#ifdef DRESSED
  float lit = scattered_of_sun(facing);
#else
  float lit = facing * facing;
#endif
#ifdef SHADOWS
  lit *= sun_visibility(world_position, normal);
#endif
  vec3 light = albedo * (sun_light() * lit + light_around.rgb) + light_around.rgb * light_around.a;
#ifdef DRESSED
  light += shine(normal, albedo, sun_light() * lit, light_around.rgb);
#endif
#ifdef DEBUG_COLORS
  light = below(debug_color, facing, light);
#endif
  color = vec4(exposed(light * haze_before.a + haze_before.rgb), 1.0);
}
