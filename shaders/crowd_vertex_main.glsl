// The crowd. A program with morphs includes morphs.glsl before it.
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
out vec2 passed_metallic_roughness_coord;
out vec2 passed_normal_coord;
out vec2 passed_occlusion_coord;
out vec4 world_tangent;
out vec4 passed_color;
out vec4 debug_color;

vec4 tinted(const InstanceRecord instance) {
  if (region >= tint_regions) return vec4(shaded(instance, color.rgb), color.a);
  return vec4(color.rgb * to_linear(unpackUnorm4x8(instance.tints[region]).rgb), color.a);
}

// How much of the vertex follows the palette entries that are weighed: from blue over green to red.
vec4 color_of_weight() {
  uvec4 places = entries_at(0u) - weighed_entry;
  float weight = dot(weights, vec4(lessThan(places, uvec4(weighed_entries))));
  vec3 low = mix(vec3(0.02, 0.04, 0.2), vec3(0.05, 0.6, 0.1), min(2.0 * weight, 1.0));
  return vec4(mix(low, vec3(1.0, 0.08, 0.02), max(2.0 * weight - 1.0, 0.0)), 0.95);
}

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
  debug_color = weighed_entries > 0u ? color_of_weight() : unpackUnorm4x8(instance.debug_color);
  gl_Position = view_projection * vec4(world_position, 1.0);
}
