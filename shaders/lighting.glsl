// Lights the whole scene, in linear colours: a warm sun, the sky above, light that the ground reflects, and haze.
const vec3 to_sun = vec3(0.5152, 0.7303, 0.4486);
const vec3 sun_light = vec3(2.05, 1.80, 1.46);
const vec3 sky_light = vec3(0.52, 0.64, 0.86);
const vec3 ground_light = vec3(0.34, 0.29, 0.24);

const vec3 haze_color = vec3(0.80, 0.80, 0.80);
const vec3 zenith_color = vec3(0.10, 0.26, 0.58);
const vec3 sun_haze = vec3(0.42, 0.26, 0.10);

vec3 sky_color(vec3 direction) {
  float height = max(direction.y, 0.0);
  vec3 sky = mix(haze_color, zenith_color, 1.0 - exp2(-height * 6.0));
  float towards_sun = max(dot(direction, to_sun), 0.0);
  float glow = towards_sun * towards_sun;
  return sky + sun_haze * glow * glow;
}

// `metres` are those of a scene of people.
vec3 through_haze(vec3 color, vec3 direction, float metres) {
  float clear = exp2(-metres * metres * 2.2e-5 / (1.0 + metres * 0.006));
  return mix(sky_color(vec3(direction.x, 0.0, direction.z)), color, clear);
}

// Gives the light that reaches a surface from the sky and the ground.
vec3 ambient_light(vec3 normal) { return mix(ground_light, sky_light, normal.y * 0.5 + 0.5); }

// Bends bright colours towards white instead of cutting them off.
vec3 exposed(vec3 light) {
  vec3 c = light * 0.92;
  return c * (1.0 + c * 0.11) / (1.0 + c * 0.55);
}

// Gives the light that exposed() turns into `color`: the positive root of its quadratic equation.
vec3 light_that_shows(vec3 color) {
  vec3 b = 1.0 - 0.55 * color;
  return (sqrt(b * b + 0.44 * color) - b) / (0.22 * 0.92);
}
