#pragma once

#include <filesystem>

#include "app/report/frame_report.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Puts the measured figures of a committed report in place of this machine's, so that pictures can be compared.
/// Errors: it cannot be read, or is no JSON object.
anim::Status fix_measured(const std::filesystem::path& report_file, FrameReport& report);

}  // namespace throng::app
