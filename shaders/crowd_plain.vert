#version 450 core
#extension GL_ARB_shader_draw_parameters : require

// The crowd where it is opaque and no more than a base colour, for crowd.frag. What changes little over a triangle is
// computed for each vertex, because triangles are as small as a few pixels.
#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#ifdef MORPHED
#include "morphs.glsl"
#endif
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"
#include "crowd_colors.glsl"
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"

out vec3 world_normal;
out vec3 passed_color;
out vec4 light_around;  // what a white surface reflects of sky and lamps; alpha: how much its edge shines
out vec4 haze_before;   // alpha: the share that it leaves of what is behind
#ifdef SHADOWS
out vec3 world_position;
#endif
#ifdef TEXTURED
out vec2 passed_texture_coord;
#endif
#ifdef DEBUG_COLORS
out vec4 debug_color;
#endif

// Light from behind shines around the edge of a body, most of all that of the sky before a low sun.
float rim_of(vec3 normal, vec3 direction) {
  float edge = 1.0 - max(-dot(normal, direction), 0.0);
  float glow = max(dot(direction, to_sun), 0.0);
  return (0.16 + 0.5 * glow * glow) * edge * edge * edge * (0.5 + 0.5 * normal.y);
}

void main() {
  InstanceRecord instance = drawn_instance();
  SkinnedVertex vertex = skinned(instance);
  vec3 place = to_world(instance, vertex.position);
  world_normal = normalize(turned(instance, vertex.normal));
  passed_color = tinted(instance).rgb;
  vec3 from_eye = place - camera_position.xyz;
  float metres = length(from_eye);
  vec3 direction = from_eye / metres;
  vec3 around = ambient_light(world_normal) * openness_on_body(place) + lamp_light(place, world_normal);
  light_around = vec4(around, rim_of(world_normal, direction));
  haze_before = haze_in_front(direction, metres / distance_scale);
#ifdef DRESSED
  way_to_eye = -direction;
#endif
#ifdef SHADOWS
  world_position = place;
#endif
#ifdef TEXTURED
  passed_texture_coord = texture_coord;
#endif
#ifdef DEBUG_COLORS
  debug_color = color_for_people(instance);
#endif
  gl_Position = view_projection * vec4(place, 1.0);
}
