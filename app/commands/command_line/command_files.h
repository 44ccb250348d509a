#pragma once

#include "app/commands/command_line/options.h"
#include "app/files/run_files.h"

namespace throng::app {

/// Each function returns the files that the options of a command name.
RunFiles files_of(const DemoOptions& options);
RunFiles files_of(const PoseOptions& options);
RunFiles files_of(const InspectOptions& options);
RunFiles files_of(const LodOptions& options);
RunFiles files_of(const BenchOptions& options);
RunFiles files_of(const BakeOptions& options);
RunFiles files_of(const CheckOptions& options);
RunFiles files_of(const CompareOptions& options);

}  // namespace throng::app
