#pragma once

#include <cstddef>
#include <filesystem>

#include "app/character/source.h"
#include "engine/base/result.h"

/// Writes what a person chooses for a character, beside its model or among the person's files. Each function returns
/// the file that it writes.
namespace throng::app {

class Show;

/// Keeps the clips of a character's roles for the next run.
Result<std::filesystem::path> save_roles(const CharacterSource& character);
/// Keeps the parts of the body that a person says for a character, for the next run.
Result<std::filesystem::path> save_rig(const CharacterSource& character);
/// Keeps the order of a character's bones for the next run.
Result<std::filesystem::path> save_bone_lod(const CharacterSource& character);
/// Writes a character's level of detail for another engine.
Result<std::filesystem::path> export_lod(const Show& show, std::size_t character);

}  // namespace throng::app
