#pragma once

#include <string>

#include "app/character/source.h"
#include "app/wardrobe/cast_rules.h"
#include "app/wardrobe/wardrobe.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Holds what the agents of a character may wear, and the rules.
struct Clothing {
  Wardrobe wardrobe;  ///< empty where nothing is drawn, or where the file of the character has no parts
  CastRules rules;    ///< without styles where nobody dresses
};

/// Returns the clothing of a character: its parts, and the rules of CharacterSource::cast_rules, or of MODEL.cast.json
/// beside its file, or even ones for a file with parts and without rules. Errors: those of read_cast_rules, and a name
/// that no part has.
anim::Result<Clothing> clothing_of(const CharacterSource& source);

/// Returns the kinds of bodies as the crowd needs them.
std::vector<BodyKind> body_kinds(const CastRules& rules);

}  // namespace throng::app
