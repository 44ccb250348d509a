#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace throng::app {

/// Returns the folder of the running program; empty if the system does not say where it is.
std::filesystem::path program_folder();

/// Returns the folders that may hold `shaders/` and `assets/`, in the order of the search: --data, $THRONG_DATA,
/// <program>/../share/throng, the source tree recorded when the program was built.
std::vector<std::filesystem::path> data_folders(const std::string& data_option);

/// Returns the path of `name` (a file or folder, such as "assets/mannequin.glb") in the first of `folders` that has it.
/// Errors: none has it; the error lists the places tried.
Result<std::filesystem::path> find_data(const std::vector<std::filesystem::path>& folders,
                                        const std::filesystem::path& name);

}  // namespace throng::app
