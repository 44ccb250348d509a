#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/character/source.h"
#include "app/people/wardrobe/cast_rules.h"
#include "app/people/wardrobe/wardrobe.h"
#include "engine/base/result.h"

namespace throng::app {

/// Holds what the agents of a character may wear, and the rules.
struct Clothing {
  Wardrobe wardrobe;        ///< empty where nothing is drawn, or where the file of the character has no parts
  CastRules rules;          ///< without styles where people do not dress
  std::string origin = {};  ///< where the rules come from, for people; empty: from no file
  std::vector<std::string> doubts = {};  ///< doubts_of() the rules
};

/// Returns the clothing of a character: its parts, and CharacterSource::rules, or else the rules in the file
/// CharacterSource::cast_rules, or in MODEL.cast.json beside its file, or even rules for a file with parts and without
/// rules. Errors: as read_cast_rules(), a name that no part has, and more than 1000 parts.
Result<Clothing> clothing_of(const CharacterSource& source);

/// Returns the file that the rules of a character come from; empty where there is none.
std::filesystem::path rules_file_of(const CharacterSource& source);

/// Returns a complaint about rules for these parts; an empty text if they suit, or if there are no parts.
std::string wrong_for(const CastRules& rules, const Wardrobe& wardrobe);

/// Returns the kinds of bodies as the crowd needs them.
std::vector<BodyKind> body_kinds(const CastRules& rules);

}  // namespace throng::app
