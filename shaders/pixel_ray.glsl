// Gives the way that a pixel looks, not unit. Include frame_uniforms.glsl before it.
layout(location = 0) uniform vec2 pixels;  // of the picture, or of its tile

vec3 ray_of_pixel() {
  vec2 place = 2.0 * gl_FragCoord.xy / pixels - 1.0;
  return ray_forward.xyz + place.x * ray_right.xyz + place.y * ray_up.xyz;
}
