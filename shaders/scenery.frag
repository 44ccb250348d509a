#version 450 core

#include "frame_uniforms.glsl"
#include "lighting.glsl"
#include "shadows.glsl"
#include "lamps.glsl"

in vec3 world_position;
in vec3 world_normal;
in vec3 albedo;
in vec3 light_around;  // what a white surface reflects of the sky, or sends out at night
in vec3 haze_before;
in vec3 clear_share;  // that the haze leaves of what is behind it
#ifdef SHINY
flat in uint kind;
#endif

out vec4 color;

#ifdef SHINY
const uint glass = 1u, water = 2u, metal = 3u;

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
vec3 mirrored(vec3 scattered, vec3 normal) {
  vec3 direction = normalize(world_position - camera_position.xyz);
  float edge = 1.0 - max(-dot(normal, direction), 0.0);
  float fresnel = edge * edge * edge * edge * edge;
  vec3 mirror_way = reflect(direction, normal);
  if (kind == metal) return mix(scattered * 0.4, environment(mirror_way, 0.4) * mix(albedo, vec3(1.0), fresnel), 0.7);
  float share = kind == water ? 0.04 + 0.96 * fresnel : 0.16 + 0.84 * fresnel;
  return mix(scattered, environment(mirror_way, kind == water ? 0.0 : 0.1), share);
}
#endif

void main() {
  vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
#ifdef SHINY
  if (kind == water) normal = rippled(normal);
#endif
  float facing = max(dot(normal, to_sun), 0.0);
#ifdef SHADOWS
  facing *= sun_visibility(world_position, normal);
#endif
  vec3 light = albedo * (sun_light() * facing + light_around + lamp_light(world_position, normal));
#ifdef SHINY
  light = mirrored(light, normal);
#endif
  color = vec4(exposed(light * clear_share + haze_before), 1.0);
}
