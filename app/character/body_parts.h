#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/character/rig_choice.h"
#include "engine/anim/asset/body_role.h"
#include "engine/base/result.h"

namespace throng::anim {
class CharacterRigs;
struct Skeleton;
}  // namespace throng::anim

namespace throng::app {

struct CharacterSource;

/// The parts of a character's body, as a person sees and chooses them.
struct BodyParts {
  std::vector<std::string> bones;  ///< keys of all bones, sorted
  std::vector<RigChoice> chosen;   ///< chosen by a person
  /// The bone of each part without a person's choice: the bone that the file names, or that names and shape suggest.
  /// Empty where none is certain.
  std::array<std::string, anim::body_role_count> guessed;
  std::string follows;                    ///< says what works, such as placed feet, and why the rest does not
  std::optional<anim::BodyRole> refused;  ///< the part that a person asked for last, in vain
  std::string refusal;                    ///< why
};

/// Returns the skeleton with the parts that its file names, without a person's choices. A surface is built for it, so a
/// choice changes no mesh.
anim::Skeleton skeleton_in_file(const CharacterSource& source);

/// `rigs` are the rigs of the character as it is.
BodyParts body_parts(const CharacterSource& source, const anim::CharacterRigs& rigs);

/// Gives a character the parts that a person chooses, in place of all former choices. Its clips and its size stay as
/// they were baked. Errors: as choose_bones(), and a part on the wrong side of a guessed part; then nothing has
/// changed.
Status take_rig(CharacterSource& source, const std::vector<RigChoice>& choices);

}  // namespace throng::app
