#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "engine/anim/base/result.h"

namespace throng::pack {

/// The bytes of a file, mapped into memory to be read. `owner` keeps them there.
struct MappedFile {
  std::span<const std::byte> bytes;
  std::shared_ptr<const void> owner;
};

/// Maps a file. It must not be cut short while it is mapped: who replaces it renames another one to its name. The error
/// says why it cannot be read, without the file's name.
anim::Result<MappedFile> map_file(const std::string& path);

}  // namespace throng::pack
