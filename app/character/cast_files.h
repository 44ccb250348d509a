#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/character/cast_entry.h"
#include "app/character/source.h"

namespace throng::app {

/// The characters of a crowd, each with its share, and the files that are not shown.
struct LoadedCast {
  std::vector<CharacterSource> characters;  ///< 1 to most_models
  std::vector<std::string> left_out;        ///< a sentence for each file of a folder that cannot be used
};

/// Returns whether a file has the ending of a model or of a pack.
bool is_model_file(const std::filesystem::path& file);

/// Loads the characters of all entries, in this order, and reads each file once. A folder stands for the models in it,
/// by name and not in folders below it; a model of clips alone gives them to the others whose bones they fit. A skin
/// "all" stands for every character of its file.
/// Errors: a file that was named cannot be shown; a folder has no character to show; there are more than most_models. A
/// file of a folder that cannot be shown is left out, unless options.import.strict.
Result<LoadedCast> load_cast(std::span<const CastEntry> entries, const LoadOptions& options = {});

/// Loads files and folders that came together, as if they lay in one folder. A file that came alone counts as named.
Result<LoadedCast> load_dropped(std::span<const std::string> files, const LoadOptions& options = {});

/// Returns whether the character has a height that can be shown. The error names `path`.
Status check_extent(const CharacterSource& character, const std::string& path);

/// Returns the entries of files without shares.
std::vector<CastEntry> cast_of(std::span<const std::string> files);

}  // namespace throng::app
