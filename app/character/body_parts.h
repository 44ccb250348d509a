#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/character/source.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/asset/body_role.h"

namespace throng::app {

/// The parts of a character's body, as a person sees and chooses them.
struct BodyParts {
  std::vector<std::string> bones;  ///< keys of all bones, sorted
  std::vector<RigChoice> said;     ///< what a person says
  /// The bone of each part without a person's word for it: the one that the file says, or that names and shape suggest.
  /// Empty where none is certain.
  std::array<std::string, anim::body_role_count> guessed;
  std::string follows;                    ///< says whether feet are placed, and so on, and why not
  std::optional<anim::BodyRole> refused;  ///< the part that a person asked for last, in vain
  std::string refusal;                    ///< why
};

/// `rigs` are those that were made of the character as it is.
BodyParts body_parts(const CharacterSource& source, const anim::CharacterRigs& rigs);

/// Gives a character the parts that a person says in place of all that a person said before. Its clips and its size
/// stay as they were baked. Errors: those of choose_bones, and a part on the wrong side of one that is guessed without
/// it; then nothing has changed.
anim::Status take_rig(CharacterSource& source, const std::vector<RigChoice>& choices);

}  // namespace throng::app
