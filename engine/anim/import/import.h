#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "throng/character.h"

#include "engine/anim/asset/model.h"
#include "engine/base/result.h"

namespace throng::import {

struct ImportOptions {
  bool strict = false;             ///< refuses repairs and omissions, and links that lead out of the model's folder
  std::uint64_t memory_limit = 0;  ///< bytes that it may hold at a time; 0: as memory/memory_account.h says
  std::span<const FileInMemory> files{};  ///< the model and what it names, in place of files of the disk; or empty
  std::map<std::string, int> channels{};  ///< attributes to carry (anim::VertexChannel), with their components, 1 to 4
};

/// Reads a .glb or .gltf (glTF 2.0) and checks everything before it is used. The error is one sentence with the file,
/// the object and what to do.
/// Reads files only below the model's own folder, and where symbolic links in it lead; with ImportOptions::files, none.
/// Names and messages are plain text (plain_text.h), whatever the file holds.
/// Never throws, crashes or hangs on any input. More memory than 64 MB and four times the files is refused before
/// it is taken. Images may hold 1 GB besides, into which they are scaled down, and JSON 256 MB
/// (memory/README.md).
Result<anim::ImportedFile> import_file(const std::string& path, const ImportOptions& options = {});

/// Imports as import_file() does, but accepts a file without skins, which has animations and no models.
Result<anim::ImportedFile> import_skins(const std::string& path, const ImportOptions& options = {});

/// Imports as import_file() does, but makes a skeleton of the animated nodes, and of all nodes above and below them,
/// where the file has no skin. Its bind pose is the rest pose. So a file that holds clips alone has a model.
Result<anim::ImportedFile> import_clips(const std::string& path, const ImportOptions& options = {});

/// Returns whether a model file has animations and no mesh, by its JSON alone. A file that cannot be read has none.
bool holds_clips_alone(const std::string& path);

}  // namespace throng::import
