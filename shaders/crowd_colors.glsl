// Computes the colour of a vertex of the crowd. Include crowd_vertex.glsl and frame_uniforms.glsl before it.
#include "color.glsl"
#include "cloth_patterns.glsl"

vec4 tinted(const InstanceRecord instance) {
  if (region == untinted_region || region >= look_regions) {
    vec3 own_color = shaded(instance, color.rgb);
#ifdef DRESSED
    lay_pattern(instance.agent, 0u, 0u);
    second_color = own_color;
#endif
    return vec4(own_color, color.a);
  }
  uint tint = looks[instance.agent].tints[region], second = looks[instance.agent].seconds[region];
  vec3 first_color = to_linear(unpackUnorm4x8(tint).rgb), other_color = to_linear(unpackUnorm4x8(second).rgb);
#ifdef DRESSED
  lay_pattern(instance.agent, tint, second);
  second_color = color.rgb * other_color;
  return vec4(color.rgb * first_color, color.a);
#else
  return vec4(color.rgb * mix(first_color, other_color, mean_share(pattern_of(tint))), color.a);
#endif
}

// How much of the vertex follows the palette entries that are weighed: from blue over green to red.
vec4 color_of_weight() {
  uvec4 places = entries_at(0u) - weighed_entry;
  float weight = dot(weights, vec4(lessThan(places, uvec4(weighed_entries))));
  vec3 low = mix(vec3(0.02, 0.04, 0.2), vec3(0.05, 0.4, 0.15), min(2.0 * weight, 1.0));
  return vec4(mix(low, vec3(1.0, 0.8, 0.05), max(2.0 * weight - 1.0, 0.0)), 0.95);
}

// The colour, linear, that stands for a value of the agent or the vertex; alpha says how much of it shows.
vec4 color_for_people(const InstanceRecord instance) {
  if (weighed_entries > 0u) return color_of_weight();
  vec4 color = unpackUnorm4x8(instance.debug_color);
  return vec4(to_linear(color.rgb), color.a);
}
