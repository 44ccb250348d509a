#version 450 core

#include "frame_uniforms.glsl"
#include "scenery_instance.glsl"
#include "color.glsl"
#include "lighting.glsl"
#include "shadows.glsl"

// The depths that are drawn first are the same, to the bit.
invariant gl_Position;

out vec3 world_position;
out vec3 world_normal;
out vec3 albedo;
out vec3 light_around;
out vec3 haze_before;
out vec3 clear_share;
flat out uint kind;
#ifdef LIT_AT_VERTICES
out vec3 seen_from_front;
out vec3 seen_from_behind;
#endif

const float glow_light = 2.2;

void main() {
  SceneryRecord record = scenery[instance];
  world_position = placed(record);
  vec3 x = column(record, 0), y = column(record, 3), z = column(record, 6);
  // Normals are divided by a stretch that points are multiplied by.
  world_normal = x * (normal.x / dot(x, x)) + y * (normal.y / dot(y, y)) + z * (normal.z / dot(z, z));
  albedo = vertex_color.rgb * mix(vec3(1.0), to_linear(unpackUnorm4x8(record.tint).rgb), nature.y);
  // Not every window is lit.
  float is_lit = fract(sin(float(record.number) * 12.9898) * 43758.5453);
  float glow = nature.x * (0.45 + 0.55 * is_lit) * night() * glow_light;
  vec3 unit_normal = normalize(world_normal);
  light_around = ambient_light(unit_normal) * openness(world_position) + glow;
  vec3 from_eye = world_position - camera_position.xyz;
  float metres = length(from_eye);
  clear_share = clear_after(metres / distance_scale);
  haze_before = haze_towards(from_eye / metres) * (1.0 - clear_share);
  kind = uint(nature.w * 255.0 + 0.5);
#ifdef LIT_AT_VERTICES
  float lit = dot(unit_normal, to_sun);
  vec3 from_front = albedo * (sun_light() * max(lit, 0.0) + light_around);
  vec3 from_behind = albedo * (sun_light() * max(-lit, 0.0) + light_around);
  // The conversion to sRGB costs a processor much for each pixel.
  seen_from_front = to_srgb(exposed(from_front * clear_share + haze_before));
  seen_from_behind = to_srgb(exposed(from_behind * clear_share + haze_before));
#endif
  gl_Position = view_projection * vec4(world_position, 1.0);
}
