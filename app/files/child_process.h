#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/anim/base/result.h"

namespace throng::app {

/// What a program said until it ended, and how it did.
struct EndedChild {
  int status = -1;     ///< its exit status; 128 and more: the signal that ended it
  std::string output;  ///< what it wrote to standard output
  std::string errors;  ///< what it wrote to standard error
};

/// How a program is run.
struct ChildTreatment {
  std::filesystem::path folder = {};  ///< where it works; empty: where we do
  unsigned seconds = 600;             ///< SIGALRM ends it after these
};

/// Runs a program, without a shell, and waits for its end. It ends with us. The first word names it: a path, or a name
/// that is looked for in PATH. Errors: it cannot be started.
anim::Result<EndedChild> run_child(const std::vector<std::string>& words, const ChildTreatment& treatment = {});

/// Calls `ask` in a copy of this process, which may crash or wait forever, and returns its text; an empty one if that
/// happened. Call it while there is one thread.
std::string ask_in_child(const std::function<std::string()>& ask, unsigned seconds);

/// Returns the path of the program that runs now. Errors: the system does not say it.
anim::Result<std::string> own_program();

/// Returns the words as a person would give them to a shell.
std::string as_typed(const std::vector<std::string>& words);

}  // namespace throng::app
