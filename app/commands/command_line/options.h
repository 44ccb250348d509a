#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/commands/bake/command.h"
#include "app/commands/bench/command.h"
#include "app/commands/check/command.h"
#include "app/commands/compare/command.h"
#include "app/commands/inspect/command.h"
#include "app/commands/lod/command.h"
#include "app/commands/pose/command.h"
#include "app/files/run_files.h"
#include "app/settings/settings.h"
#include "engine/anim/kernel/choose_kernels.h"

namespace throng::app {

/// The text that --help or --version shows on standard output.
struct ShowText {
  std::string text;
};

/// The reason why a command line is refused: one line that names the option and says what is allowed. The exit status
/// is 2.
struct UsageError {
  std::string message;
};

using ParsedCommand = std::variant<DemoOptions, PoseOptions, InspectOptions, LodOptions, BenchOptions, BakeOptions,
                                   CheckOptions, CompareOptions, ShowText, UsageError>;

/// Reads a command line as README.md beside it documents it. `arguments` are without the program's own name.
ParsedCommand parse_command_line(const std::vector<std::string>& arguments);

/// Each function returns the files that the options of a command name.
RunFiles files_of(const DemoOptions& options);
RunFiles files_of(const PoseOptions& options);
RunFiles files_of(const InspectOptions& options);
RunFiles files_of(const LodOptions& options);
RunFiles files_of(const BenchOptions& options);
RunFiles files_of(const BakeOptions& options);
RunFiles files_of(const CheckOptions& options);
RunFiles files_of(const CompareOptions& options);

/// Makes the program use the SIMD target that the options of a command name from now on. Commands that pose nothing
/// have no such option.
void choose_kernels(const auto& options) {
  if constexpr (requires { options.kernels; }) {
    if (options.kernels != nullptr) anim::choose_kernels(*options.kernels);
  }
}

}  // namespace throng::app
