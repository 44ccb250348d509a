// Computes the base colour and the alpha of a point of the crowd's surface.
layout(binding = 0) uniform sampler2D base_color_texture;

layout(location = 1) uniform vec4 base_color;

in vec2 passed_texture_coord;
in vec4 passed_color;

vec4 surface_color() { return base_color * passed_color * texture(base_color_texture, passed_texture_coord); }
