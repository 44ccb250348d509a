#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace throng::app {

/// Returns why these files must not be replaced: git could not bring them back, since they have changes that are not
/// committed, it does not know them, or there is no git. Missing files have nothing to lose.
std::optional<std::string> missing_in_git(const std::vector<std::filesystem::path>& files);

}  // namespace throng::app
