// Computes the colour of a vertex of the crowd. Include crowd_vertex.glsl and frame_uniforms.glsl before it.
#include "color.glsl"

const uint tint_regions = 5u;

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

// The colour, linear, that stands for a value of the agent or the vertex; alpha says how much of it shows.
vec4 color_for_people(const InstanceRecord instance) {
  if (weighed_entries > 0u) return color_of_weight();
  vec4 color = unpackUnorm4x8(instance.debug_color);
  return vec4(to_linear(color.rgb), color.a);
}
