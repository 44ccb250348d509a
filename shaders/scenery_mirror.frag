#version 450 core

#include "frame_uniforms.glsl"
#include "scenery_light.glsl"

flat in uint kind;

out vec4 color;

const uint water = 2u, metal = 3u;  // else glass

// Three trains of waves, a hand wide and less.
vec3 rippled(vec3 normal) {
  float seconds = float(now % 1000000000u) * 1e-6;
  vec2 at = world_position.xz;
  vec2 slope = vec2(0.8, 0.6) * cos(dot(at, vec2(8.0, 6.0)) - 2.1 * seconds) +
               vec2(-0.5, 0.87) * cos(dot(at, vec2(-9.0, 15.6)) - 3.3 * seconds) +
               vec2(0.95, -0.3) * cos(dot(at, vec2(28.0, -9.0)) - 4.7 * seconds);
  return normalize(normal - vec3(slope.x, 0.0, slope.y) * 0.045);
}

// Adds what the surface mirrors to the light that it scatters.
vec3 with_mirror(vec3 light, vec3 normal, vec3 direction) {
  float edge = 1.0 - max(-dot(normal, direction), 0.0);
  float fresnel = edge * edge * edge * edge * edge;
  vec3 mirror_way = reflect(direction, normal);
  if (kind == metal) return mix(light * 0.4, environment(mirror_way, 0.4) * mix(albedo, vec3(1.0), fresnel), 0.7);
  float share = kind == water ? 0.04 + 0.96 * fresnel : 0.16 + 0.84 * fresnel;
  return mix(light, environment(mirror_way, kind == water ? 0.0 : 0.1), share);
}

void main() {
  vec3 normal = facing_normal();
  if (kind == water) normal = rippled(normal);
  vec3 direction = normalize(world_position - camera_position.xyz);
  color = seen_from_camera(with_mirror(scattered(normal), normal, direction));
}
