#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/base/files/input_file.h"

namespace throng::app {

/// The lines of frames that an earlier part of a run has written, one after the other from frame 1 on.
class KeptLines {
 public:
  /// Takes the lines of a file, or of the part beside it that a killed run has left if that has more.
  explicit KeptLines(const std::filesystem::path& file);

  /// Returns how many frames, from the first on, have a whole line.
  int count() const { return count_; }
  /// Returns the next of these lines, without its end; nothing after the last.
  std::optional<std::string> next();
  /// Removes the part beside the file. Call it when all lines are elsewhere.
  void remove_parts() const;

 private:
  bool read_from(const std::filesystem::path& file);
  std::optional<std::string> read_line();

  std::filesystem::path file_, source_;
  std::optional<InputFile> input_;
  std::string pending_;  // text that was read and not returned yet
  int count_ = 0, given_ = 0;
};

}  // namespace throng::app
