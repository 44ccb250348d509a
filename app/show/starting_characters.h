#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/character/cast_files.h"
#include "app/settings/settings.h"

namespace throng::app {

/// Ends a run before it begins, with this exit status.
struct StartError : Error {
  int status = 1;
};
/// Sets the error and returns false.
bool fail(StartError& error, int status, std::string message);

/// Returns how the command line asks for files to be read.
LoadOptions load_options(const DemoOptions& options);

/// Loads the characters that the command line names, or the built-in one. They have the roles that were kept, changed
/// by the roles that the command line chooses. `progress` may be null.
std::optional<LoadedCast> load_starting_characters(const DemoOptions& options, StartError& error,
                                                   const LoadProgress& progress = {});

}  // namespace throng::app
