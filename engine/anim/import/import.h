#pragma once

#include <string>

#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"

namespace throng::import {

/// Reads a .glb or .gltf (glTF 2.0) and checks everything that it uses before use. The error is one sentence naming the
/// file, the object and what to do. Reads files only below the model's own folder. Never throws, crashes or hangs on
/// any input; memory is bounded by the size of the files.
anim::Result<anim::ImportedFile> import_file(const std::string& path);

/// The same, but a file without skins is not refused: it has animations and no models.
anim::Result<anim::ImportedFile> import_skins(const std::string& path);

}  // namespace throng::import
