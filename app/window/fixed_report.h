#pragma once

#include <filesystem>

#include "app/show/report/frame_report.h"
#include "engine/base/result.h"

namespace throng::app {

/// Replaces the figures that this machine measured by a committed report's, so that pictures can be compared.
/// Errors: the file cannot be read, or is no JSON object.
anim::Status fix_measured(const std::filesystem::path& report_file, FrameReport& report);

}  // namespace throng::app
