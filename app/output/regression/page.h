#pragma once

#include "app/output/regression/outcome.h"
#include "engine/base/files/output_file.h"

namespace throng::app {

/// Writes a run as one HTML page that needs no other file and no network. It shows failures first; a slider divides
/// expected and actual picture, and buttons show the difference and the heat map in their place. Pictures of a case
/// that passed to the bit are shown once.
Status write_page(const RegressionRun& run, const std::filesystem::path& file);

}  // namespace throng::app
