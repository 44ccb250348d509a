// Repeats the layout of engine/render/frame/frame_uniforms.h.
layout(std140, binding = 0) uniform FrameUniforms {
  mat4 view_projection;
  vec4 camera_position;
  vec4 ray_right;
  vec4 ray_up;
  vec4 ray_forward;
  uint now;  // microseconds, modulo 2^32
  float distance_scale;  // the haze is thinner by it
  uint weighed_entry, weighed_entries;  // palette entries whose weights are shown; 0 entries: none
  vec4 ground_shape;  // half sides of the core along x and z, radius of the corners, half width
  bool ground_is_endless;  // no fields begin around it
  float ground_unit;
};
