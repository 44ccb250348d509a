#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace throng {

/// Holds the output of a program until its end, and how it ended.
struct EndedChild {
  int status = -1;     ///< its exit status; 128 and more: the signal that ended it
  std::string output;  ///< what it wrote to standard output
  std::string errors;  ///< what it wrote to standard error
};

/// Says how a program is run.
struct ChildTreatment {
  std::filesystem::path folder = {};  ///< where it works; empty: where we do
  unsigned seconds = 600;             ///< SIGALRM ends it after these
};

/// Runs a program, without a shell, and waits for its end. It ends with us. The first word names it: a path, or a name
/// that is looked for in PATH. Errors: the system does not start it. On Windows none is started.
Result<EndedChild> run_child(const std::vector<std::string>& words, const ChildTreatment& treatment = {});

/// Calls `ask` in a copy of this process, which may crash or wait forever, and returns its text; an empty one if that
/// happened. Call it while there is one thread.
std::string ask_in_child(const std::function<std::string()>& ask, unsigned seconds);

/// Returns the words as a new program of POSIX takes them: their letters, and a null at the end.
std::vector<char*> as_arguments(std::vector<std::string>& words);
/// Waits for the end of a child of POSIX. Returns its exit status; 128 and more: the signal that ended it.
int status_of(int child);

/// Returns the path of the program that runs now. Errors: the system does not say it. Windows is not asked.
Result<std::string> own_program();

}  // namespace throng
