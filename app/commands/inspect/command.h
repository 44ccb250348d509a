#pragma once

#include <string>

#include "app/commands/inspect/options.h"
#include "engine/anim/asset/model.h"

namespace throng::app {

/// What an imported file holds, for a person: skeletons, levels, skins, clips, meshes, and what was repaired.
std::string inspection_text(const anim::ImportedFile& file);

/// The same as one JSON object: `file`, `animations` [name], `repairs` [sentence] and `models`, each with `name`,
/// `path` ("rigid" or "general"), `bones` [name], `level_bone_counts`, `palette_entries`, `skins`, `clips`, `meshes`,
/// `materials`, `images`.
std::string inspection_json(const anim::ImportedFile& file);

/// `throng inspect`. Returns the exit status; a file that is refused gives one line on stderr.
int run_inspect(const InspectOptions& options);

}  // namespace throng::app
