#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/import.h"
#include "engine/base/result.h"

namespace throng::app {

/// A file of clips, read once for all characters that play them.
struct ClipFile {
  std::string path;
  anim::ImportedFile imported;
  bool must_fit = true;  ///< false: a character that has none of its bones, or another body, goes without
};

/// Reads files of clips, which need no mesh and no skin, with the parts of the body that a person chose for each.
/// Errors: a file that cannot be read.
Result<std::vector<ClipFile>> read_clip_files(std::span<const std::string> paths,
                                              const import::ImportOptions& options = {});

std::vector<const ClipFile*> pointers_to(std::span<const ClipFile> files);

/// Takes a file that was read for its clips if it has some and nothing to draw; else leaves it as it is.
std::optional<ClipFile> take_clips_alone(const std::string& path, anim::ImportedFile& file);

/// Returns whether a model file has clips and no mesh, by a look at its text alone.
bool has_clips_alone(const std::string& path);

/// Reads a file of clips alone; returns nothing where it holds more or cannot be read.
std::optional<ClipFile> read_clips_alone(const std::string& path, const import::ImportOptions& options = {});

/// Checks whether a skeleton can play clips. Errors, which name the skeleton by `file`: there are none, no bone of them
/// is known to it, or their body stands upright while it rests on four feet.
Status check_clips(const ClipFile& clips, const anim::Skeleton& skeleton, const std::string& file);

/// Adds the clips of other files to one of the models of `file`, for its own skeleton: as they are where both rest
/// alike, else retargeted. Sentences in file.notes say for each file how its clips fit and which of its bones no bone
/// follows. Clips without a name of their own take their file's. The model is in the space of its file, with no size or
/// place yet. Returns the paths of the files whose clips were taken.
/// Errors: a file that has no clips; those of check_clips() for a file that must fit.
Result<std::vector<std::string>> add_clips_from(std::span<const ClipFile* const> clip_files, anim::ImportedFile& file,
                                                std::size_t model);

/// Adds clips to the largest model from files that are yet to be read, after giving it the parts of the body that a
/// person chose for `path`, the file of `file`.
Status add_clips_to(const std::string& path, std::span<const std::string> clip_files, anim::ImportedFile& file,
                    const import::ImportOptions& options = {});

}  // namespace throng::app
