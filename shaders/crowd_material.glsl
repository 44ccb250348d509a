// Lights a point of the crowd's surface as glTF 2.0, appendix B, says. Include crowd_shading.glsl before it.
#include "microfacets.glsl"

layout(binding = 2) uniform sampler2D metallic_roughness_texture;
layout(binding = 3) uniform sampler2D normal_texture;
layout(binding = 4) uniform sampler2D occlusion_texture;

// Metallic, roughness, scale of the normal texture, strength of occlusion; 0: no such texture.
layout(location = 6) uniform vec4 factors;

in vec2 passed_metallic_roughness_coord;
in vec2 passed_normal_coord;
in vec2 passed_occlusion_coord;
in vec4 world_tangent;

const float least_roughness = 0.06;  // the sun is no point
const float dielectric = 0.04;       // share of light that plastic, skin and cloth mirror head on

// The bump of the normal texture, whose u grows along x; its length tells how alike the bumps of a texel are.
vec3 read_bump() { return 2.0 * texture(normal_texture, passed_normal_coord).xyz - 1.0; }

vec3 bumped_normal(vec3 bump) {
  vec3 normal = normalize(world_normal);
  float side = gl_FrontFacing ? 1.0 : -1.0;
  if (dot(world_tangent.xyz, world_tangent.xyz) == 0.0) return side * normal;
  vec3 tangent = normalize(world_tangent.xyz);
  vec3 bitangent = cross(normal, tangent) * sign(world_tangent.w);
  vec2 slope = factors.z * bump.xy;
  return side * normalize(slope.x * tangent + slope.y * bitangent + bump.z * normal);
}

// Bumps that are too small to be seen spread the light as roughness does (Pettineo, "Rendering The Order: 1886", 2013).
float spread_of_bumps(vec3 bump) {
  float alike = min(length(bump) + 0.006, 1.0);  // 8 bits a channel make it a little short
  float squared = alike * alike;
  return alike < 1.0 ? 0.5 * (1.0 - squared) / (3.0 * alike - alike * squared) : 0.0;
}

// So do shapes that turn within a pixel (Tokuyoshi and Kaplanyan, "Improved Geometric Specular Antialiasing", 2019). Far
// armour would flicker without it.
float spread_of_shape(vec3 normal) {
  vec3 across = dFdx(normal), down = dFdy(normal);
  return min(0.25 * (dot(across, across) + dot(down, down)), 0.18);
}

float spread_out(float roughness, float spread) {
  float alpha = roughness * roughness;
  return sqrt(sqrt(min(alpha * alpha + spread, 1.0)));
}

Microfacets microfacets_of(vec3 base, vec3 to_eye) {
  vec2 rough_and_metallic = texture(metallic_roughness_texture, passed_metallic_roughness_coord).gb * factors.yx;
  float roughness = clamp(rough_and_metallic.x, least_roughness, 1.0);
  float metallic = clamp(rough_and_metallic.y, 0.0, 1.0);
  Microfacets surface;
  surface.normal = facing_normal();
  float spread = spread_of_shape(surface.normal);
  if (factors.z != 0.0) {
    vec3 bump = read_bump();
    surface.normal = bumped_normal(bump);
    spread += spread_of_bumps(bump);
  }
  surface.to_eye = to_eye;
  surface.scattered = base * (1.0 - metallic);
  surface.mirrored = mix(vec3(dielectric), base, metallic);
  surface.roughness = spread_out(roughness, spread);
  return surface;
}

vec3 reflected_by_material(vec3 base) {
  Microfacets surface = microfacets_of(base, normalize(camera_position.xyz - world_position));
  float occlusion = 1.0 + factors.w * (texture(occlusion_texture, passed_occlusion_coord).r - 1.0);
  float lit = sun_visibility(world_position, facing_normal());
  float open = openness_on_body(world_position) * occlusion;
  vec3 lamps = surface.scattered * lamp_light(world_position, surface.normal);
  return lit * from_sun(surface) + open * from_around(surface) + lamps;
}
