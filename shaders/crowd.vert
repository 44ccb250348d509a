#version 450 core
#extension GL_ARB_shader_draw_parameters : require

// The crowd with any material. crowd_plain.vert is for those that are no more than a base colour.
#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#ifdef MORPHED
#include "morphs.glsl"
#endif
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"
#include "crowd_colors.glsl"

out vec3 world_position;
out vec3 world_normal;
out vec2 passed_texture_coord;
out vec2 passed_emission_coord;
out vec2 passed_metallic_roughness_coord;
out vec2 passed_normal_coord;
out vec2 passed_occlusion_coord;
out vec4 world_tangent;
out vec4 passed_color;
#ifdef DEBUG_COLORS
out vec4 debug_color;
#endif

void main() {
  InstanceRecord instance = drawn_instance();
  SkinnedVertex vertex = skinned(instance);
  world_position = to_world(instance, vertex.position);
  world_normal = turned(instance, vertex.normal);
  passed_texture_coord = texture_coord;
  passed_emission_coord = emission_coord;
  passed_metallic_roughness_coord = metallic_roughness_coord;
  passed_normal_coord = normal_coord;
  passed_occlusion_coord = occlusion_coord;
  world_tangent = vec4(turned(instance, vertex.tangent), tangent.w);
  passed_color = tinted(instance);
#ifdef DEBUG_COLORS
  debug_color = color_for_people(instance);
#endif
  gl_Position = view_projection * vec4(world_position, 1.0);
}
