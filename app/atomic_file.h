#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/anim/base/result.h"

namespace throng::app {

/// Writes `contents` beside `file` under a temporary name and renames it: `file` is whole or as it was, also when two
/// programs write it at once. A device or pipe is written as it is, a symbolic link is followed.
anim::Status write_whole_file(const std::filesystem::path& file, std::string_view contents);

/// As write_whole_file; `-` means standard output.
anim::Status write_output(const std::string& file, std::string_view contents);

/// Whether write_whole_file() could write there now, so that an hour's run does not end in a full stop. Leaves nothing.
/// `option` begins the sentence of the error.
anim::Status check_can_be_written(std::string_view option, const std::filesystem::path& file);

}  // namespace throng::app
