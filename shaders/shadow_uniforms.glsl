// Repeats the layout of engine/render/light/shadow_uniforms.h.
layout(std140, binding = 2) uniform ShadowUniforms {
  mat4 cascade_to_map[4];
  vec4 cascade_reach;
  vec4 cascade_texel;
  vec4 depth_of_place;
  vec4 crowd_map_place;
  vec4 lamp_map_place;
};
