#pragma once

#include <string_view>

namespace throng::app {

/// The exit status of the program; other programs rely on the numbers.
enum ExitStatus : int { exit_done = 0, exit_job_failed = 1, exit_usage = 2 };

/// Puts the one line on stderr that a failure has, "throng: " and the sentence, and returns `status`.
int end_with(ExitStatus status, std::string_view sentence);

}  // namespace throng::app
