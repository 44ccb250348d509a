#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/settings/preset.h"
#include "app/settings/tuning_pair.h"
#include "app/show/camera/camera_bookmarks.h"
#include "app/show/request/chosen_character.h"
#include "engine/base/result.h"

namespace throng::app {

/// All that a person set up: the characters, the values, and the cameras.
struct CrowdSetup {
  std::vector<ChosenCharacter> characters;  ///< 1 to most_models
  Preset preset;                            ///< its tuning is the one in use
  TuningPair pair = {};                     ///< the values that are compared with it
  CameraBookmarks bookmarks = {};
};

inline constexpr const char* crowd_file_ending = ".throng";
bool is_crowd_file(const std::filesystem::path& file);
/// Returns the NAMEs of all NAME.throng in a folder, sorted.
std::vector<std::string> crowd_names(const std::filesystem::path& folder);

CrowdSetup crowd_setup(std::span<const CharacterSource> people, const Preset& preset);

/// Writes the file NAME.throng whole or not at all: one JSON object with "version", "characters", "values", which are
/// a preset's, and where they are not empty "compare" and "bookmarks". Names of files are relative to the folder
/// of NAME.throng, so that both can move together.
Status write_crowd_file(const std::filesystem::path& file, const CrowdSetup& setup);
/// Reads such a file. Values that it does not have keep their defaults. The error is one line that names the file, what
/// is wrong in it and what is allowed.
Result<CrowdSetup> read_crowd_file(const std::filesystem::path& file);

}  // namespace throng::app
