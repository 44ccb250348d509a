// Makes a ribbon of pixels from a line between two points of clip space.
const float least_w = 0.06;  // in front of the near plane

bool is_behind(vec4 a, vec4 b) { return max(a.w, b.w) < least_w; }

// Finds where the line from `outside` to `inside` enters the space in front of the camera.
vec4 clipped(vec4 outside, vec4 inside) {
  return outside.w >= least_w ? outside : mix(outside, inside, (least_w - outside.w) / (inside.w - outside.w));
}

// Gives the way from one point to the other in a picture of that size, times two.
vec2 way_between(vec4 from, vec4 to, vec2 picture) { return (to.xy / to.w - from.xy / from.w) * picture; }

vec2 turned_left(vec2 way) { return normalize(vec2(-way.y, way.x)); }

// Moves a point of clip space sideways by so many pixels.
vec4 shifted(vec4 point, vec2 pixels, vec2 picture) {
  return point + vec4(2.0 * pixels / picture * point.w, 0.0, 0.0);
}
