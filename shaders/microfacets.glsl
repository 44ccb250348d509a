// The reflection of rough surfaces, as glTF 2.0, appendix B, says: GGX, Smith's height-correlated shadowing, Schlick's
// Fresnel and Lambert. Include lighting.glsl before it.
struct Microfacets {
  vec3 normal;
  vec3 to_eye;
  vec3 scattered;  // share of light that goes into the surface and comes out again everywhere
  vec3 mirrored;   // share of light that the surface mirrors head on
  float roughness;
};

float facing_eye(const Microfacets surface) { return max(abs(dot(surface.normal, surface.to_eye)), 1e-3); }

// Gives what the surface sends to the eye of the light of the sun.
vec3 from_sun(const Microfacets surface) {
  float facing_sun = max(dot(surface.normal, to_sun), 0.0);
  if (facing_sun == 0.0) return vec3(0.0);
  vec3 half_way = normalize(to_sun + surface.to_eye);
  float facing_half = max(dot(surface.normal, half_way), 0.0);
  float alpha = surface.roughness * surface.roughness, squared = alpha * alpha;
  float spread = facing_half * facing_half * (squared - 1.0) + 1.0;
  float eye = facing_eye(surface);
  float shadowing = facing_sun * sqrt(eye * eye * (1.0 - squared) + squared) +
                    eye * sqrt(facing_sun * facing_sun * (1.0 - squared) + squared);
  // sun_light() is what white reflects, so pi cancels out.
  float highlight = squared / (spread * spread) * 0.5 / shadowing;
  vec3 fresnel = surface.mirrored +
                 (1.0 - surface.mirrored) * pow(1.0 - clamp(dot(surface.to_eye, half_way), 0.0, 1.0), 5.0);
  return sun_light() * facing_sun * ((1.0 - fresnel) * surface.scattered + fresnel * highlight);
}

// Gives the factor and the offset of `mirrored` for light from everywhere (Karis, "Physically Based Shading on Mobile",
// 2014).
vec2 mirrored_share(float roughness, float facing) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * facing)) * r.x + r.y;
  return vec2(-1.04, 1.04) * a + r.zw;
}

// Gives what the surface sends to the eye of the light of sky and ground. Rough metals keep the light that they mirror
// more than once (Fdez-Aguera, "A Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting", 2019).
vec3 from_around(const Microfacets surface) {
  vec2 share = mirrored_share(surface.roughness, facing_eye(surface));
  vec3 once = surface.mirrored * share.x + share.y;
  float lost = 1.0 - share.x - share.y;
  vec3 average = surface.mirrored + (1.0 - surface.mirrored) / 21.0;
  vec3 again = once * average * lost / (1.0 - average * lost);
  vec3 scattered = again + surface.scattered * (1.0 - once - again);
  return once * environment(reflect(-surface.to_eye, surface.normal), surface.roughness) + scattered * ambient_light(surface.normal);
}
