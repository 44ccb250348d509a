#pragma once

#include <string_view>

#include "engine/base/result.h"

namespace throng::app {

/// The exit status of the program; other programs rely on the numbers.
enum ExitStatus : int { exit_done = 0, exit_job_failed = 1, exit_usage = 2 };

/// Returns the exit status of a run that a signal ended, as shells have it: 130 for SIGINT.
constexpr int exit_of_signal(int signal) { return 128 + signal; }

/// Puts the one line on stderr that a failure has, "throng: " and the sentence, and returns `status`.
int end_with(ExitStatus status, std::string_view sentence);

/// Returns exit_done where a job went well; else ends it with its error and exit_job_failed.
int end_with(const Status& outcome);

/// Makes every failure in a thread or without a handler end the program with one line and exit_job_failed. A pipe
/// without a reader and a file that grows too large become errors of their writer.
void end_in_words();

/// Returns the sentence for the exception in the current handler.
std::string_view sentence_of_failure();

}  // namespace throng::app
