#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "engine/anim/base/transform.h"
#include "engine/anim/kernel/palette/packed_palette.h"
#include "engine/anim/survey/surface_points.h"

/// Measures on screen how far two poses of one character differ. Pure functions, no allocation.
namespace throng::anim {

/// What the vertex shader shows (shaders/skinning.glsl): a blend of the palettes of two slots, of which a mesh that is
/// skinned to the kept bones of a level reads some entries.
struct ShownPaletteJob {
  PaletteDestination from;                      ///< at least the entries that `kept_entries` names
  PaletteDestination to;                        ///< likewise; may be `from`
  std::span<const PackingFrame> packing = {};   ///< [entries] what unpacks them; empty: they are matrices
  float blend = 1.0F;                           ///< 0 shows `from`, 1 shows `to`
  std::span<const std::uint16_t> kept_entries;  ///< [entries] which one stands for each at the level shown
  std::span<PaletteMatrix> shown;               ///< out, [entries]
};
bool is_valid(const ShownPaletteJob& job);
void blend_shown_palette(const ShownPaletteJob& job);

/// How far the shader has come from one slot to the other (blend_of in shaders/skinning.glsl); microseconds modulo
/// 2^32.
float blend_of(std::uint32_t blend_start, std::uint32_t blend_duration, std::uint32_t now);

/// A picture of some size, and how a character's space comes to it.
struct ModelOnScreen {
  glm::mat4 model_to_clip{1.0F};  ///< clip space of OpenGL
  glm::vec2 half_size{0.0F};      ///< pixels
};

/// On-screen errors of one agent, point by point.
struct SurfaceErrors {
  std::array<glm::vec2, most_surface_points> pixels;  ///< shown minus exact; of the points in the picture
  std::bitset<most_surface_points> in_picture;        ///< where either of both is
  float largest = 0.0F;                               ///< length, pixels; 0 if no point is in the picture
};

/// `shown` and `exact`: palettes of all entries, model space.
void measure_surface(const SurfacePoints& points, std::span<const PaletteMatrix> shown,
                     std::span<const PaletteMatrix> exact, const ModelOnScreen& screen, SurfaceErrors& errors);

/// The largest change of an error of a point that is in both pictures, pixels.
float largest_change(const SurfaceErrors& before, const SurfaceErrors& now);

}  // namespace throng::anim
