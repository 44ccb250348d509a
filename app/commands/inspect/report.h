#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/survey/placement_guess.h"
#include "engine/tracks/trajectories.h"

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

/// Says for a person what a file of trajectories holds: people, rows, time and place, findings and oddities.
std::string tracks_text(const Trajectories& tracks);

/// Returns the same facts as one JSON object; README.md beside this file lists the keys.
std::string tracks_json(const Trajectories& tracks);

}  // namespace throng::app
