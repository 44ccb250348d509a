#pragma once

#include <string>

namespace throng::app {

/// Returns what `--version` shows: the program and its commit, SIMD targets, contexts, Mesa, ffmpeg; a line each. It
/// asks the driver in a process of its own, so that one that crashes or waits costs no more than its line.
std::string version_text();

}  // namespace throng::app
