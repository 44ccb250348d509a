#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/base/result.h"

namespace throng::app {

/// The skin that casts every character of a file.
inline constexpr const char* all_skins = "all";

/// A file, and one of its characters.
struct CharacterFile {
  std::string path;
  std::string skin;  ///< the name of a character, or its number from 1 on; empty: the largest
};

/// Reads "FILE" or "FILE#SKIN". A file whose own name holds the "#" goes first.
CharacterFile character_file(const std::string& text);

/// Returns "FILE#SKIN"; a text that has a skin stays as it is.
std::string with_skin(const std::string& file, const std::string& skin);

/// Returns a name for each model of a file that has a mesh, largest first: the name of its skin or mesh, or its number
/// from 1 on, so that no two are equal.
std::vector<std::string> character_names(const anim::ImportedFile& file);

/// Returns the index of the chosen model. The error lists the known names.
Result<std::size_t> choose_model(const anim::ImportedFile& file, const std::string& skin);

}  // namespace throng::app
