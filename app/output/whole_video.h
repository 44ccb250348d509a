#pragma once

#include <filesystem>

namespace throng::app {

/// Returns whether an .mp4 or a .webm that ffmpeg wrote is whole: the lengths of its outermost parts add up to the
/// file's, and an .mp4 has its media and the table of its frames. ffmpeg writes these lengths last.
bool is_whole_video(const std::filesystem::path& file);

}  // namespace throng::app
