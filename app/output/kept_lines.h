#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/files/input_file.h"

namespace throng::app {

/// The lines of frames that an earlier part of a run has written, one after the other: that of frame 1 is the first.
class KeptLines {
 public:
  /// Takes the lines of a file, or of what a run that was killed has left beside it if that has more.
  explicit KeptLines(const std::filesystem::path& file);

  /// Returns of how many frames from the first on there is a whole line.
  int count() const { return count_; }
  /// Returns the next of these lines, without its end; nothing after the last.
  std::optional<std::string> next();
  /// Removes what was left beside the file. Call it when all lines are elsewhere.
  void remove_parts() const;

 private:
  bool read_from(const std::filesystem::path& file);
  std::optional<std::string> read_line();

  std::filesystem::path file_, source_;
  std::optional<InputFile> input_;
  std::string pending_;  // what was read and not given yet
  int count_ = 0, given_ = 0;
};

}  // namespace throng::app
