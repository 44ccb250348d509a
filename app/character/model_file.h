#pragma once

#include <string>

#include "engine/anim/import/import.h"

namespace throng::app {

/// Says what a file must hold: a character, or also animations alone (import.h).
enum class ModelFileUse : unsigned char { characters, skins, clips };

/// Reads a model file with all its models and keys: glTF, or a pack. "PACK#NAME" names a file of a pack that holds
/// several. The error names the file and what to do.
Result<anim::ImportedFile> read_model_file(const std::string& file, const import::ImportOptions& options = {},
                                           ModelFileUse use = ModelFileUse::characters);

}  // namespace throng::app
