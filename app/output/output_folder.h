#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace throng::app {

/// A folder of numbered files that a run writes. The file `run.json` in it names the run.
class OutputFolder {
 public:
  /// Makes the folder where there is none, and takes one of the same run. Errors begin with `option`: the folder is of
  /// another or unknown run, or cannot be made.
  static Result<OutputFolder> open(std::string_view option, const std::filesystem::path& folder,
                                   const std::vector<std::string>& run);

  /// Returns the file of a frame, counted from 1: "frame_000001.png" where `kind` is "frame".
  std::filesystem::path file(std::string_view kind, int frame) const;
  const std::filesystem::path& path() const { return folder_; }

 private:
  explicit OutputFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
};

}  // namespace throng::app
