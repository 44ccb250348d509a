#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/settings/agent_colors.h"
#include "app/settings/settings.h"

namespace throng::app {

/// The facts that decide, beside the tuning itself, whether a value has an effect.
struct Situation {
  bool selected = false;             ///< an agent is selected
  bool places_feet = true;           ///< a character of the crowd has feet that can be placed
  bool can_pack = true;              ///< a character of the crowd has palettes that can be packed
  bool has_wardrobe = true;          ///< a character of the crowd has parts to wear, or bodies
  int bone_levels = 4;               ///< the most bone levels of a character
  int mesh_levels = mesh_lod_steps;  ///< the most mesh LODs of a character; 1: its mesh alone
  int pus = 2;                       ///< PUs at work
  bool has_tracks = true;            ///< a file of trajectories was read
};

/// Returns why a value has no effect on poses, picture or report, as the rest of a sentence that begins with "No
/// effect: "; nothing where it has one. `key` is the key of a row of tuning_values(), or the name of a member of
/// LodInspection or TakenAway.
std::optional<std::string> idle_reason(std::string_view key, const Tuning& tuning, const Situation& situation);

/// Returns why a person cannot choose one of the words of a value now, as such a rest of a sentence; null where the
/// choice is free.
const char* why_not_choose(std::string_view key, std::string_view word, const Tuning& tuning,
                           const Situation& situation);

}  // namespace throng::app
