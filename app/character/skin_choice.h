#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// The skin that casts every character of a file.
inline constexpr const char* all_skins = "all";

/// A file, and which of its characters is meant.
struct CharacterFile {
  std::string path;
  std::string skin;  ///< the name of a character, or its number from 1 on; empty: the largest
};

/// Reads "FILE" or "FILE#SKIN". A file whose own name holds the "#" goes first.
CharacterFile character_file(const std::string& text);

/// Returns "FILE#SKIN"; a text that has a skin stays as it is.
std::string with_skin(const std::string& file, const std::string& skin);

/// Returns a name for each model of a file that has a mesh, largest first: that of its skin, or of its mesh, or its
/// number from 1 on, so that no two are equal.
std::vector<std::string> character_names(const anim::ImportedFile& file);

/// Returns the model that is meant. The error lists the names that there are.
anim::Result<std::size_t> choose_model(const anim::ImportedFile& file, const std::string& skin);

}  // namespace throng::app
