#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/character/cast_entry.h"
#include "app/character/role_table.h"
#include "app/character/source.h"
#include "app/report/camera_report.h"
#include "app/settings/preset.h"
#include "app/settings/tuning_pair.h"
#include "engine/anim/base/result.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// A character of a crowd file, and all that a person chose for it.
struct CrowdCharacter {
  std::string file;  ///< "FILE" or "FILE#SKIN"; empty: the built-in character
  double share = 1.0;
  std::vector<std::string> clip_files;    ///< other files whose clips it plays too
  anim::PlacementChoice placement;        ///< what was asked of its size and place
  std::vector<RoleChoice> clips;          ///< those that it does not name are guessed
  std::vector<std::string> bones;         ///< in order, as bone_keys() has them; empty: as it is loaded
  std::vector<int> level_counts;          ///< as in BoneLodChoice
  std::vector<RigChoice> rig;             ///< the parts of the body that a person said
  std::optional<std::string> rules = {};  ///< who wears what, as JSON, where a person chose it

  friend bool operator==(const CrowdCharacter&, const CrowdCharacter&) = default;
};

/// All that a person set up: who is there, the values, and the cameras.
struct CrowdSetup {
  std::vector<CrowdCharacter> characters;  ///< 1 to most_models
  Preset preset;                           ///< its tuning is the one in use
  TuningPair pair = {};                    ///< what that is compared with
  CameraBookmarks bookmarks = {};
};

inline constexpr const char* crowd_file_ending = ".throng";
bool is_crowd_file(const std::filesystem::path& file);
/// Returns the NAMEs of all NAME.throng in a folder, sorted.
std::vector<std::string> crowd_names(const std::filesystem::path& folder);

CrowdSetup crowd_setup(std::span<const CharacterSource> people, const Preset& preset);

/// Writes the file NAME.throng whole or not at all: one JSON object with "version", "characters", "values", which are
/// those of a preset, and where they are not empty "compare" and "bookmarks". Names of files are relative to the folder
/// of NAME.throng, so that both can move together.
anim::Status write_crowd_file(const std::filesystem::path& file, const CrowdSetup& setup);
/// Reads such a file. Values that it does not have keep their defaults. The error is one line that names the file, what
/// is wrong in it and what is allowed.
anim::Result<CrowdSetup> read_crowd_file(const std::filesystem::path& file);

/// Returns the entries that load the characters; none for the built-in one alone.
std::vector<CastEntry> entries_of(std::span<const CrowdCharacter> characters);

/// Gives a character that was loaded for it all that the person chose. Errors name the character and what it has not.
anim::Status become(const CrowdCharacter& wanted, CharacterSource& character);

}  // namespace throng::app
