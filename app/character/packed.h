#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/character/skin_choice.h"
#include "app/character/source.h"
#include "engine/anim/pack/pack.h"

namespace throng::app {

/// Names a character of a pack.
struct PackedCharacter {
  std::size_t file = 0;   ///< of the files that were baked into the pack
  std::size_t model = 0;  ///< of that file
};

/// Finds the character that `skin` names: the first of the file of that name, or else the character of that name;
/// without a name, the first of all. The error lists the known names.
Result<PackedCharacter> choose_packed(const pack::Pack& pack, const std::string& path, const std::string& skin);

/// Returns the name behind "FILE#" of the first character of each file of a pack, or, with `all`, of each character.
std::vector<std::string> packed_names(const pack::Pack& pack, bool all);

/// A strict run takes no character of a file that was repaired. The error names one of the repairs.
Status check_strictly(const pack::Pack& pack, std::size_t file, const std::string& path);

/// Takes a character out of a pack. If a person asks for another size, other clips or other parts of the body now,
/// bakes it anew from the file that the pack keeps whole.
Result<CharacterSource> take_packed(const pack::Pack& pack, const CharacterFile& wanted, const std::string& name,
                                    const BoneLodFile* kept, const LoadOptions& options);

}  // namespace throng::app
