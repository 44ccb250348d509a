#version 450 core

#include "frame_uniforms.glsl"
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"
#include "pixel_ray.glsl"
#include "paving.glsl"

flat in vec3 light_of_sun;
flat in vec3 light_of_sky;

out vec4 color;

void main() {
  vec3 direction = normalize(ray_of_pixel());
  // Every ray stays just below the horizon, so that the derivatives are valid on both sides of it.
  float drop = max(-direction.y, 1e-4);
  float metres = max(camera_position.y, 0.01) / drop;
  vec2 ground = camera_position.xz + direction.xz * metres;
  vec2 footprint = abs(dFdx(ground)) + abs(dFdy(ground));
  vec3 place = vec3(ground.x, 0.0, ground.y), up = vec3(0.0, 1.0, 0.0);
  vec3 light = light_of_sun * sun_visibility(place, up) + light_of_sky * openness(place) + lamp_light(place, up);
  color = vec4(exposed(through_haze(paving(ground, footprint) * light, direction, metres / distance_scale)), 1.0);
}
