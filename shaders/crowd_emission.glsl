// Computes what a point of the crowd's surface sends out by itself. Include crowd_material.glsl before it.
layout(binding = 1) uniform sampler2D emission_texture;

layout(location = 3) uniform vec3 emission;
layout(location = 4) uniform bool unlit;

in vec2 passed_emission_coord;

// What is brighter than white of the screen is so many times that white's light.
vec3 light_of(vec3 color) {
  float times = max(brightest(color), 1.0);
  return times * light_that_shows(color / times);
}

vec3 glowing(vec3 color) {
  vec3 shining = light_of(emission * texture(emission_texture, passed_emission_coord).rgb);
  return unlit ? seen(light_of(color) + shining) : seen(reflected_by_material(color) + shining);
}
