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
  double error_metres = 0;  ///< anim::BoneLod::level_error_metres
  double nanoseconds = 0;   ///< time of an agent's update
};

/// One mesh LOD of a character. It depends on no bone level.
struct MeshLevel {
  std::uint32_t triangles = 0;
  float error_metres = 0.0F;  ///< as render::MeshErrorMeter measures it
};

/// Returns the bone levels of a character, with times by the cost model.
std::vector<LodLevel> lod_levels(const CharacterSource& source);

/// Returns mesh LODs, the full mesh first. Both spans have one element a LOD.
std::vector<MeshLevel> mesh_levels(std::span<const std::uint32_t> triangles, std::span<const float> errors);

/// Returns a JSON object of a character's level of detail (app/commands/lod/README.md): intervals between updates and
/// bone levels by distance, mesh LODs by height on screen, the bones in order, errors. `pixels_per_unit` are the pixels
/// that one metre covers at a distance of one metre.
std::string lod_as_json(const CharacterSource& source, std::span<const LodLevel> levels,
                        std::span<const MeshLevel> meshes, const anim::LodRules& rules, double pixels_per_unit);

}  // namespace throng::app
