#pragma once

#include <string>

namespace throng::app {

/// Returns the text of `--version`: the program and its commit, SIMD targets, contexts, Mesa, ffmpeg; a line each. It
/// asks the driver in a process of its own, so that a driver that crashes or waits costs no more than its line.
std::string version_text();

}  // namespace throng::app
