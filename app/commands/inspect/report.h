#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// A model in the size and place that the crowd gives it.
struct InspectedModel {
  anim::Model model;
  anim::GuessedPlacement placed;
};

/// Counts the bytes of the stream that a clip plays from.
std::uint32_t bytes_played(const anim::BakedClip& clip);

/// Says for a person, in tables, what a file holds: each character with its size, clips, meshes and materials, and what
/// import repaired, left out and guessed. `models` are the file's, taken out of it.
std::string inspection_text(const anim::ImportedFile& file, std::span<const InspectedModel> models);

}  // namespace throng::app
