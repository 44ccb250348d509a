#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "throng/render/mesh_error_value.h"

#include "app/character/source.h"
#include "app/settings/settings.h"
#include "engine/anim/lod/lod_choices.h"

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
  render::MeshError error = {};  ///< metres
};

/// Returns the bone levels of a character, with times by the cost model.
std::vector<LodLevel> lod_levels(const CharacterSource& source);

/// Returns mesh LODs, the full mesh first. Both spans have one element a LOD.
std::vector<MeshLevel> mesh_levels(std::span<const std::uint32_t> triangles, std::span<const render::MeshError> errors);

/// The level of detail in force, and the view that distances are for.
struct LodInForce {
  Tuning tuning;
  anim::LodCharacter character = {};  ///< read under LodRule::budget, as is the tolerance
  float tolerance_pixels = 0;         ///< pixels that a pose may be off; above 0
  float pixels_per_unit = 1;          ///< pixels that one metre covers at a distance of one metre; read by all rules
};

/// Returns a JSON object of the level of detail of a character (app/commands/lod/README.md): by the rule in force how
/// often it is updated and with how many bones, from which distance; mesh LODs by height on screen; the bones in order;
/// errors. It is for frames of a sixtieth of a second, and names no folder.
std::string lod_as_json(const CharacterSource& source, std::span<const LodLevel> levels,
                        std::span<const MeshLevel> meshes, const LodInForce& lod);

}  // namespace throng::app
