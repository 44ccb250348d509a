// The crowd, projected along the sun's rays onto the ground. A program with morphs includes morphs.glsl before it.
#include "frame_uniforms.glsl"
#include "instance_record.glsl"
#include "skinning.glsl"
#include "variants.glsl"
#include "crowd_vertex.glsl"
#include "lighting.glsl"

out vec3 ground_position;
out vec2 passed_texture_coord;
out vec4 passed_color;

void main() {
  InstanceRecord instance = drawn_instance();
  passed_texture_coord = texture_coord;
  passed_color = color;
  vec3 point = to_world(instance, skinned(instance).position);
  // Projects the point along the sun's rays onto y = 0.
  ground_position = vec3(point.xz - to_sun.xz * (max(point.y, 0.0) / to_sun.y), 0.0).xzy;
  gl_Position = view_projection * vec4(ground_position, 1.0);
}
