#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/character/source.h"
#include "engine/anim/lod/lod.h"

namespace throng::app {

/// One bone level of a character, as another engine may want to know it.
struct LodLevel {
  int bones = 0;
  int palette_entries = 0;
  double error_metres = 0;      ///< anim::BoneLod::level_error_metres
  double nanoseconds = 0;       ///< time of an agent's update
  std::uint32_t triangles = 0;  ///< triangles of the mesh LOD that goes with it
  double mesh_ratio = 1;        ///< share of the full mesh's triangles
};

/// Returns the levels of a character with `triangles_by_lod` of its meshes (may be empty) and times by the cost model.
std::vector<LodLevel> lod_levels(const CharacterSource& source, std::span<const std::uint32_t> triangles_by_lod);

/// Returns a JSON object of a character's level of detail (app/commands/lod/README.md): intervals between updates and
/// bone levels by distance, the bones in order, errors, mesh ratios. `pixels_per_unit` are the pixels that one metre
/// covers at a distance of one metre.
std::string lod_as_json(const CharacterSource& source, std::span<const LodLevel> levels, const anim::LodRules& rules,
                        double pixels_per_unit);

}  // namespace throng::app
