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

/// The palette that the vertex shader shows (shaders/skinning.glsl): a blend of the palettes of two slots, of which a
/// mesh that is skinned to the kept bones of a level reads some entries.
struct ShownPaletteJob {
  PaletteDestination from;                      ///< has at least the entries that `kept_entries` names
  PaletteDestination to;                        ///< has these too; may be `from`
  std::span<const PackingFrame> packing = {};   ///< [entries] the frames that unpack them; empty: they are matrices
  float blend = 1.0F;                           ///< 0 shows `from`, 1 shows `to`
  std::span<const std::uint16_t> kept_entries;  ///< [entries] the entry that stands for each at the level shown
  std::span<PaletteMatrix> shown;               ///< out, [entries]
};
bool is_valid(const ShownPaletteJob& job);
void blend_shown_palette(const ShownPaletteJob& job);

/// Returns how far the shader has come from one slot to the other, 0 to 1 (blend_of in shaders/skinning.glsl). Times
/// are microseconds modulo 2^32.
float blend_of(std::uint32_t blend_start, std::uint32_t blend_duration, std::uint32_t now);

/// A picture of some size, and the matrix that takes a character's space to it.
struct ModelOnScreen {
  glm::mat4 model_to_clip{1.0F};  ///< clip space of OpenGL
  glm::vec2 half_size{0.0F};      ///< pixels
};

/// The errors of one agent on screen, point by point.
struct SurfaceErrors {
  std::array<glm::vec2, most_surface_points> pixels;  ///< shown minus exact, for the points in the picture
  std::bitset<most_surface_points> in_picture;        ///< points that either palette puts into the picture
  float largest = 0.0F;                               ///< length, pixels; 0 if no point is in the picture
};

/// Measures the errors. `shown` and `exact` are palettes of all entries, in model space.
void measure_surface(const SurfacePoints& points, std::span<const PaletteMatrix> shown,
                     std::span<const PaletteMatrix> exact, const ModelOnScreen& screen, SurfaceErrors& errors);

/// Returns the largest change of an error of a point that is in both pictures, in pixels.
float largest_change(const SurfaceErrors& before, const SurfaceErrors& now);

}  // namespace throng::anim
