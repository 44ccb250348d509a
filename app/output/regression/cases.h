#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/output/regression/tolerance.h"
#include "app/settings/settings.h"
#include "engine/base/result.h"

namespace throng::app {

/// A picture that is drawn and held against the expected one.
struct RegressionCase {
  std::string name;                   ///< letters, digits, -, _ and .
  std::vector<std::string> words;     ///< the options that draw it, without context and files to write
  std::vector<ContextKind> contexts;  ///< egl, osmesa or both
  Tolerance tolerance;
  std::filesystem::path expected;
};

/// Holds a file of cases. app/commands/check/README.md has its keys.
struct RegressionCases {
  std::filesystem::path folder;    ///< of the file; paths in it are relative to this folder
  std::filesystem::path pictures;  ///< the folder of expected pictures that no case names
  int bits = 8;                    ///< a channel in which expected pictures are kept, and both are compared
  Tolerance tolerance;             ///< of cases without one of their own
  std::vector<RegressionCase> cases;
};

/// Reads cases. Errors are ends of sentences that begin with the file's name, and say the place and what is allowed.
Result<RegressionCases> parse_cases(std::string_view text, const std::filesystem::path& folder);

/// Reads cases from a file. Errors are whole sentences.
Result<RegressionCases> read_cases(const std::filesystem::path& file);

}  // namespace throng::app
