#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/character/cast_entry.h"
#include "app/character/source.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// A character of a crowd, and all that a person chose for it, as crowd files and recordings keep it.
struct ChosenCharacter {
  std::string file;              ///< "FILE" or "FILE#SKIN"; empty: the built-in character
  std::string fingerprint = {};  ///< of bones and clips, whatever the bones' order; empty: any character of the file
  double share = 1.0;            ///< of the crowd; is_share() holds
  std::vector<std::string> clip_files = {};  ///< other files whose clips it plays too
  anim::PlacementChoice placement = {};      ///< the requested size and place
  std::vector<RoleChoice> clips = {};        ///< the roles that it does not name are guessed
  std::vector<std::string> bones = {};       ///< in order, as bone_keys() has them; empty: as it is loaded
  std::vector<int> level_counts = {};        ///< as in BoneLodChoice
  std::vector<RigChoice> rig = {};           ///< the parts of the body that a person said
  std::optional<std::string> rules = {};     ///< CharacterSource::rules; nothing: the files beside the model decide

  friend bool operator==(const ChosenCharacter&, const ChosenCharacter&) = default;
};

/// Returns all choices that make a character, with its fingerprint.
ChosenCharacter exactly(const CharacterSource& character);
std::vector<ChosenCharacter> exactly(std::span<const CharacterSource> characters);
/// Returns a person's choices for a character: without a fingerprint, and without rules that came with the program.
ChosenCharacter chosen(const CharacterSource& character);

/// Returns whether every role plays a clip that the character has, or none.
bool has_clips(const CharacterSource& character, const RoleClips& roles);

/// Returns the entries that load the characters; none for the built-in one alone.
std::vector<CastEntry> entries_of(std::span<const ChosenCharacter> characters);

/// Gives a character that was loaded for it all that the person chose. Errors name the character: it has another
/// fingerprint, or it lacks a chosen thing.
Status become(const ChosenCharacter& wanted, CharacterSource& character);

/// Returns an object with "model", "share", "clips", "clips_from", "placement", "rig", "level_counts", "bones", and
/// where they are there "fingerprint" and "rules".
Json to_json(const ChosenCharacter& character);
Json to_json(std::span<const ChosenCharacter> characters);
/// Reads 1 to most_models characters. `complaint` says what is wrong first, as the end of a sentence.
std::vector<ChosenCharacter> read_characters(const Json& json, std::optional<std::string>& complaint);

/// Returns a placement as {"up": "y", "ground": "feet", "scale": 0.01}, without a ground or a scale that is guessed.
Json to_json(const anim::PlacementChoice& placement);
/// Reads it. `name` begins a complaint.
void read_placement(const std::string& name, const Json& json, std::optional<std::string>& complaint,
                    anim::PlacementChoice& placement);

/// Returns rules as JSON, and reads them; null where no agent dresses. The read text is one of rules, whatever they
/// name.
Json rules_json(const std::string& rules);
std::string rules_in(const Json& json);

}  // namespace throng::app
