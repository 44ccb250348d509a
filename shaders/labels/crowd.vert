#version 450 core
#extension GL_ARB_shader_draw_parameters : require

// The crowd as labels have it: each instance by its number. With ALONE, each is drawn into a cell of its own.
#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#ifdef MORPHED
#include "morphs.glsl"
#endif
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"

#ifdef ALONE
layout(location = 21) uniform uint first_instance;
layout(location = 22) uniform vec2 target_per_picture;  // pixels of the target over those of the picture
layout(location = 23) uniform vec2 target_pixels;

// Where an instance is drawn: left, bottom, right and top in the target, and how far it is moved there.
struct Cell {
  ivec4 place;
  ivec2 shift;
  ivec2 unused;
};
layout(std430, binding = 9) readonly buffer Cells { Cell cells[]; };

flat out ivec4 cell;
#else
flat out uint label;
#endif
#ifdef CUT_OUT
out vec2 passed_texture_coord;
out vec4 passed_color;
#endif

void main() {
  InstanceRecord instance = drawn_instance();
#ifdef CUT_OUT
  passed_texture_coord = texture_coord;
  passed_color = color;
#endif
  gl_Position = view_projection * vec4(to_world(instance, skinned(instance).position), 1.0);
#ifdef ALONE
  Cell own = cells[drawn_number() - first_instance];
  cell = own.place;
  vec2 corner = 2.0 * vec2(own.shift) / target_pixels - 1.0;
  gl_Position.xy = (gl_Position.xy + gl_Position.w) / target_per_picture + corner * gl_Position.w;
#else
  label = instance.agent + 1u;
#endif
}
