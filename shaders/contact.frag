#version 450 core

layout(location = 0) uniform float sun_side;

in vec2 place;
in float metres;

out vec4 darkening;

void main() {
  float contact = max(1.0 - dot(place, place) / (0.42 * 0.42), 0.0);
  vec2 streak_place = (place - vec2(0.0, 0.5)) / vec2(0.30, 0.95);
  float streak = max(1.0 - dot(streak_place, streak_place), 0.0) * sun_side;
  float shade = 1.0 - (1.0 - 0.55 * contact * contact) * (1.0 - 0.50 * streak);
  float clear = exp2(-metres * 0.014);
  darkening = vec4(vec3(1.0) - vec3(1.0, 0.95, 0.85) * (shade * clear), 1.0);
}
