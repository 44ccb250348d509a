// The crowd, opaque and lit. A program with morphs includes morphs.glsl before it.
#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"
#include "color.glsl"

const uint tint_regions = 5u;

out vec3 world_position;
out vec3 world_normal;
out vec2 passed_texture_coord;
out vec2 passed_emission_coord;
out vec4 passed_color;
flat out vec4 debug_color;

vec4 tinted(const InstanceRecord instance) {
  if (region >= tint_regions) return vec4(shaded(instance, color.rgb), color.a);
  return vec4(color.rgb * to_linear(unpackUnorm4x8(instance.tints[region]).rgb), color.a);
}

void main() {
  InstanceRecord instance = drawn_instance();
  SkinnedVertex vertex = skinned(instance);
  world_position = to_world(instance, vertex.position);
  world_normal = turned(instance, vertex.normal);
  passed_texture_coord = texture_coord;
  passed_emission_coord = emission_coord;
  passed_color = tinted(instance);
  debug_color = unpackUnorm4x8(instance.debug_color);
  gl_Position = view_projection * vec4(world_position, 1.0);
}
