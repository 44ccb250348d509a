#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/character/source.h"
#include "app/show/lod/lod_export.h"
#include "engine/base/result.h"

namespace throng::app {

/// Holds the bone levels and the mesh LODs of a character, with the time and error of each.
struct LodCurve {
  std::vector<LodLevel> bones;
  std::vector<MeshLevel> meshes;
};

/// Sets LodLevel::nanoseconds to the time of an agent's update at each level on this machine: one PU, a crowd whose
/// agents blend two clips each, the levels in turns. The error is the animation system's.
Status time_levels(const CharacterSource& source, std::vector<LodLevel>& levels);

/// Returns the height on screen, in pixels, below which the error of a level is at most one pixel; infinite without
/// error.
double pixels_tall_for_one_pixel(const LodLevel& level, double height_metres);

/// Says of each level whether it is worth its switch: it takes at most 90% of the time of the last level that pays, and
/// is within a pixel of the truth on characters that are still 10 pixels tall. Level 0 always pays.
std::vector<bool> levels_that_pay(std::span<const LodLevel> levels, double height_metres);

/// Returns a table of bones, time and error and a table of triangles and error, for a person. Errors are in pixels of a
/// character `pixels` tall. A sentence follows for each level that does not pay.
std::string curve_as_text(const CharacterSource& source, const LodCurve& curve, int pixels);

/// Returns the curve as a JSON object.
std::string curve_as_json(const CharacterSource& source, const LodCurve& curve, int pixels);

/// Returns an SVG of the bone levels: time in percent of level 0, and pixels, over the bones kept.
std::string curve_as_svg(const CharacterSource& source, const LodCurve& curve, int pixels);

}  // namespace throng::app
