#pragma once

#include <cstdint>
#include <optional>

#include "app/character/source.h"
#include "app/settings/settings.h"
#include "engine/crowd/system_view.h"

namespace throng::app {

/// The share of Tuning::error_px that a coarser mesh may show at most. Poses may show the rest.
inline constexpr float mesh_share_of_error = 0.5F;

/// Returns the limit on the errors of poses alone.
float pose_error_limit(const Tuning& tuning);
/// Returns how a tuning has meshes chosen.
MeshRules mesh_rules(const Tuning& tuning);
/// Returns the rules of a tuning with its limits, as far as they concern poses.
LodRules lod_rules(const Tuning& tuning);
/// Returns all that decides how exactly a tuned crowd is seen. `selected` is the agent that is looked at.
ViewRules view_rules(const Tuning& tuning, std::optional<std::uint32_t> selected);

/// Returns a character for a view. Feet that are placed cost on top.
ViewedCharacter viewed_character(const CharacterSource& source);
/// Returns the character for level of detail, which `source` outlives.
anim::LodCharacter lod_character(const CharacterSource& source);

}  // namespace throng::app
