#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"
#include "engine/anim/import/import.h"

namespace throng::app {

/// Adds the clips of other files to one of the models of `file`, for its own skeleton: as they are where both rest
/// alike, else retargeted. A file of clips needs no mesh and no skin. Sentences in file.notes say for each file how
/// its clips fit and which of its bones nobody follows. Clips without a name of their own are called as their file.
/// The model is in the space of its file, with no size or place yet.
/// Errors: a file that cannot be read, has no clips, or has no bone that the model knows.
anim::Status add_clips_from(std::span<const std::string> clip_files, anim::ImportedFile& file, std::size_t model,
                            const import::ImportOptions& options = {});

/// Does the same with the largest model, after giving it the parts of the body that a person chose for `path`, the file
/// of `file`.
anim::Status add_clips_to(const std::string& path, std::span<const std::string> clip_files, anim::ImportedFile& file,
                          const import::ImportOptions& options = {});

/// Returns whether a file has clips and nothing to draw. A file that cannot be read has none.
bool has_clips_alone(const std::string& file);

}  // namespace throng::app
