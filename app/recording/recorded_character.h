#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/character/cast_entry.h"
#include "app/character/roles.h"
#include "app/character/source.h"
#include "engine/anim/base/result.h"
#include "engine/anim/import/json/json.h"

namespace throng::app {

/// A character of a recording: the name of its file (empty: the built-in character), its fingerprint, and what a person
/// can choose for it.
struct RecordedCharacter {
  std::string file;
  std::string fingerprint;  ///< of bones and clips, whatever the bones' order; 16 hexadecimal digits
  RoleClips roles = no_clips();
  std::vector<std::string> bones;            ///< in order, as bone_keys() has them
  std::vector<int> level_counts;             ///< as in BoneLodChoice
  anim::PlacementChoice placement = {};      ///< what was asked of its size and place
  double share = 1.0;                        ///< of the crowd
  std::vector<std::string> clip_files = {};  ///< other files whose clips it plays too
  /// The parts of the body that a person said; nothing in recordings of before they were kept.
  std::optional<std::vector<RigChoice>> rig = {};
  /// CharacterSource::rules. Older recordings have none, and the files here decide.
  std::optional<std::string> rules = {};

  friend bool operator==(const RecordedCharacter&, const RecordedCharacter&) = default;
};

RecordedCharacter recorded(const CharacterSource& character);
std::vector<RecordedCharacter> recorded(std::span<const CharacterSource> characters);

/// Returns whether every role plays a clip that the character has, or none.
bool has_clips(const CharacterSource& character, const RoleClips& roles);

/// Reads the "rig" of a character; returns nothing where the JSON is none.
std::optional<std::vector<RigChoice>> recorded_rig(const Json& json);

/// Returns rules as JSON, and reads them; null where nobody dresses. What is read is a text of rules, whatever they
/// name.
Json recorded_rules_json(const std::string& rules);
std::string recorded_rules(const Json& json);

/// Returns a placement as [scale, 0 where it is guessed; up axis; ground rule], numbers all of them.
Json placement_json(const anim::PlacementChoice& placement);
/// Reads it; returns nothing where the JSON is none.
std::optional<anim::PlacementChoice> recorded_placement(const Json& json);

/// Gives a character the recorded order of bones, levels, parts of the body and roles. Errors: it is another character,
/// or it lacks what the recording asks for.
anim::Status become_recorded(const RecordedCharacter& as_recorded, CharacterSource& character);

/// Returns the entries that load these characters again, with the clips that they play.
std::vector<CastEntry> entries_of(std::span<const RecordedCharacter> characters);

/// Returns a list of objects with "file", "fingerprint", "roles", "bones", "level_counts", "share", "clip_files",
/// "rig", "placement" and "rules".
Json to_json(std::span<const RecordedCharacter> characters);
/// Reads 1 to most_models characters. `complaint` is what is wrong first, as the end of a sentence.
std::vector<RecordedCharacter> read_characters(std::span<const Json> json, std::optional<std::string>& complaint);

}  // namespace throng::app
