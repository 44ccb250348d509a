// Converts sRGB to linear, closely enough for colours that a person picked.
vec3 to_linear(vec3 srgb) { return srgb * (srgb * (srgb * 0.305306011 + 0.682171111) + 0.012522878); }
