#version 450 core

#include "frame_uniforms.glsl"
#include "scenery_instance.glsl"
#include "color.glsl"

out vec3 world_position;
out vec3 world_normal;
out vec3 albedo;
out float glow;
flat out uint kind;

void main() {
  SceneryRecord record = scenery[instance];
  world_position = placed(record);
  vec3 x = column(record, 0), y = column(record, 3), z = column(record, 6);
  // Normals are divided by a stretch that points are multiplied by.
  world_normal = x * (normal.x / dot(x, x)) + y * (normal.y / dot(y, y)) + z * (normal.z / dot(z, z));
  albedo = vertex_color.rgb * mix(vec3(1.0), to_linear(unpackUnorm4x8(record.tint).rgb), nature.y);
  // Not every window is lit.
  float lit = fract(sin(float(record.number) * 12.9898) * 43758.5453);
  glow = nature.x * (0.45 + 0.55 * lit);
  kind = uint(nature.w * 255.0 + 0.5);
  gl_Position = view_projection * vec4(world_position, 1.0);
}
