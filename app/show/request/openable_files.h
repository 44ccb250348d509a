#pragma once

#include <filesystem>

namespace throng::app {

/// Returns whether a file has the ending of walls for a recorded crowd.
bool are_walls(const std::filesystem::path& file);
/// Returns whether a file is a crowd file or has trajectories, which take the place of what is shown.
bool is_crowd(const std::filesystem::path& file);
/// Returns whether the program can open a file, as far as its ending and its first bytes say.
bool is_openable(const std::filesystem::path& file);

}  // namespace throng::app
