// Repeats the layout of engine/render/light/light_uniforms.h.
layout(std140, binding = 1) uniform LightUniforms {
  vec3 to_sun;
  float night_share;
  vec4 sun;
  vec4 sky_harmonics[9];
  vec4 haze;
  vec4 haze_at_sun;
  vec4 clearing;
};
