#pragma once

#include <cstddef>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "engine/render/light/cascades.h"

namespace throng::render {

/// Block 2 of every scene program: where shadow maps lie, and the maps of how crowded and how lamplit a place is.
/// `shaders/shadow_uniforms.glsl` repeats the layout (std140).
///
///      0  to map                    a matrix for each cascade: x and y 0 to 1 over the map, z as in it
///    256  reach                     the depth at which each cascade ends
///    272  texel                     metres, of each
///    288  depth                     x y z and w: their product with a place is its depth
///    304  crowd map x, z            its corner, metres; 1 / metres of its side; a person's own part in it
///    320  lamp map x, z              its corner, metres; 1 / metres of its side; the height up to which lamps shine
struct ShadowUniforms {
  glm::mat4 to_map[cascade_count];
  glm::vec4 reach;
  glm::vec4 texel;
  glm::vec4 depth;
  glm::vec4 crowd_map;
  glm::vec4 lamp_map;
};
static_assert(cascade_count == 4);
static_assert(sizeof(ShadowUniforms) == 336);
static_assert(offsetof(ShadowUniforms, reach) == 256);
static_assert(offsetof(ShadowUniforms, crowd_map) == 304);
static_assert(offsetof(ShadowUniforms, lamp_map) == 320);

}  // namespace throng::render
