// Lights the whole scene, in linear and exposed colours: the sun or the moon, the sky, light that the ground reflects,
// and haze.
#include "light_uniforms.glsl"

// The sky, as far as rays from the ground see it: the directions of the upper half of an octahedron, unfolded into a
// square. Alpha is the share that clouds leave of what is behind them.
layout(binding = 9) uniform sampler2D sky_map;
// What is all around, blurred the more the coarser the mip level.
layout(binding = 10) uniform samplerCube environment_map;

const float coarsest_environment = 5.0;  // mip level: SkyPicture::environment_levels - 1

// Gives what a white surface that faces the sun reflects of it.
vec3 sun_light() { return sun.rgb; }

// Gives 0 by day, and 1 when windows and lamps are lit.
float night() { return night_share; }

// Gives what a white surface reflects of sky and ground.
vec3 ambient_light(vec3 n) {
  vec3 linear = sky_harmonics[0].rgb + sky_harmonics[1].rgb * n.y + sky_harmonics[2].rgb * n.z +
                sky_harmonics[3].rgb * n.x;
  vec3 squares = sky_harmonics[4].rgb * (n.x * n.y) + sky_harmonics[5].rgb * (n.y * n.z) +
                 sky_harmonics[6].rgb * (3.0 * n.y * n.y - 1.0) + sky_harmonics[7].rgb * (n.x * n.z) +
                 sky_harmonics[8].rgb * (n.z * n.z - n.x * n.x);
  return max(linear + squares, vec3(0.0));
}

// Gives what a surface of that roughness mirrors from a direction.
vec3 environment(vec3 direction, float roughness) {
  return textureLod(environment_map, direction, roughness * coarsest_environment).rgb;
}

// Gives the haze in a direction along the ground.
vec3 haze_towards(vec3 direction) {
  vec2 along = normalize(direction.xz + vec2(1e-6));
  float towards = max(0.5 + 0.5 * dot(along, vec2(haze.a, haze_at_sun.a)), 0.0);
  float glow = towards * towards;
  return haze.rgb + haze_at_sun.rgb * (glow * glow);
}

// Gives the share of light that comes through so many metres of haze, which takes blue away sooner than red. `metres` are
// those of a scene of people.
vec3 clear_after(float metres) { return exp(-metres * clearing.rgb); }

// Gives the haze in front of what is so many metres away; alpha is the share that it leaves of that.
vec4 haze_in_front(vec3 direction, float metres) {
  float clear = clear_after(metres).g;
  return vec4(haze_towards(direction) * (1.0 - clear), clear);
}

vec3 through_haze(vec3 light, vec3 direction, float metres) {
  return mix(haze_towards(direction), light, clear_after(metres));
}

vec3 sky_color(vec3 direction) {
  vec3 up = vec3(direction.x, max(direction.y, 0.0), direction.z);
  vec2 folded = up.xz / (abs(up.x) + up.y + abs(up.z));
  vec4 seen = textureLod(sky_map, 0.5 + 0.5 * vec2(folded.x + folded.y, folded.y - folded.x), 0.0);
  seen.rgb = mix(haze_towards(direction), seen.rgb, smoothstep(0.0, 0.07, direction.y));
  float towards_sun = dot(direction, to_sun);
  vec3 disc = sun.rgb * (30.0 * smoothstep(0.99993, 0.99997, towards_sun));
  return seen.rgb + disc * seen.a;
}

// Bends bright colours towards white and keeps dark ones apart, as film does: a curve of the form that Narkowicz fits to
// ACES (2015), with less of a toe, because most of a crowd is in its own shade.
const float film_speed = 0.62;
const vec2 film_bright = vec2(2.51, 0.12);
const vec3 film_dark = vec3(2.43, 0.68, 0.16);

vec3 film(vec3 light) {
  vec3 x = light * film_speed;
  return (x * (film_bright.x * x + film_bright.y)) / (x * (film_dark.x * x + film_dark.y) + film_dark.z);
}

// The slope of film().
vec3 film_slope(vec3 light) {
  vec3 x = light * film_speed;
  vec3 over = x * (film_bright.x * x + film_bright.y), under = x * (film_dark.x * x + film_dark.y) + film_dark.z;
  vec3 slope = (2.0 * film_bright.x * x + film_bright.y) * under - over * (2.0 * film_dark.x * x + film_dark.y);
  return film_speed * slope / (under * under);
}

// Gives the light that film() turns into `color`: the positive root of its quadratic equation.
vec3 light_on_film(vec3 color) {
  vec3 a = film_bright.x - film_dark.x * color, b = film_bright.y - film_dark.y * color;
  return (sqrt(b * b + 4.0 * film_dark.z * a * color) - b) / (2.0 * film_speed * a);
}

float brightest(vec3 color) { return max(max(color.r, color.g), max(color.b, 1e-5)); }

// A curve for each channel alone turns orange into yellow and blue into cyan in the sun. So a part of the color only
// becomes as bright as its brightest channel, and keeps its hue.
const float hue_kept = 0.6;

vec3 exposed(vec3 light) {
  vec3 on_film = film(light);  // its brightest channel is that of the light
  return mix(on_film, light * (brightest(on_film) / brightest(light)), hue_kept);
}

// Gives the light that exposed() turns into `color`. The brightest channel is the same on film; for the others a few
// steps of Newton's method do.
vec3 light_that_shows(vec3 color) {
  float most = brightest(color);
  float kept = hue_kept * most / light_on_film(vec3(most)).r;
  vec3 light = light_on_film(color);
  for (int i = 0; i < 3; ++i) {
    vec3 off = (1.0 - hue_kept) * film(light) + kept * light - color;
    light = max(light - off / ((1.0 - hue_kept) * film_slope(light) + kept), vec3(0.0));
  }
  return light;
}

// Lays a colour that stands for a value over light. Where the surface faces the sun it looks as in the legend.
vec3 below(vec4 value_color, float facing, vec3 light) {
  if (value_color.a == 0.0) return light;
  return mix(light, light_that_shows(value_color.rgb * (0.35 + 0.65 * facing)), value_color.a);
}
