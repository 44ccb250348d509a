#version 450 core
#extension GL_ARB_shader_draw_parameters : require

// The crowd as the sun sees it.
#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#ifdef MORPHED
#include "morphs.glsl"
#endif
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"

layout(location = 20) uniform mat4 to_map;

out vec2 passed_texture_coord;
out vec4 passed_color;

void main() {
  InstanceRecord instance = drawn_instance();
  passed_texture_coord = texture_coord;
  passed_color = color;
  gl_Position = to_map * vec4(to_world(instance, skinned(instance).position), 1.0);
}
