#pragma once

#include <filesystem>

namespace throng::app {

/// Writes the built-in character as a model of another size: all of it below a node that scales it so many times.
void write_scaled_mannequin(const std::filesystem::path& file, double times);

}  // namespace throng::app
