// Include light_uniforms.glsl before it. The light wraps around, because cloth and skin have no hard edge between light
// and shade.
float sun_share(vec3 normal) { return max((dot(normal, to_sun) + 0.25) / 1.25, 0.0); }
