// Computes what a point of the crowd's surface sends out by itself. Include crowd_shading.glsl before it.
layout(binding = 1) uniform sampler2D emission_texture;

layout(location = 3) uniform vec3 emission;
layout(location = 4) uniform bool unlit;

in vec2 passed_emission_coord;

vec3 glowing(vec3 albedo) {
  vec3 shining = light_that_shows(emission * texture(emission_texture, passed_emission_coord).rgb);
  return unlit ? seen(light_that_shows(albedo) + shining) : seen(reflected(albedo) + shining);
}
