#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "tests/window/child_process.h"

namespace throng::app {

/// The pixels of a display, where nothing asks for others.
inline constexpr glm::ivec2 usual_screen{1400, 900};

/// An invisible display of its own (Xvfb), and what a person does at it (xdotool). It ends with its owner.
class Display {
 public:
  /// Starts Xvfb of that size with a free number. Programs at it keep in `folder` what a person keeps.
  Display(const std::filesystem::path& folder, glm::ivec2 size, Deadline deadline);

  bool is_there() const { return !name_.empty(); }
  /// Returns what DISPLAY says, such as ":1".
  const std::string& name() const { return name_; }
  /// Returns the environment of a program at it, which draws in software.
  std::vector<std::string> environment() const;
  /// Gives words to xdotool; several commands may follow each other. Returns whether it did as it was told.
  bool xdotool(const std::vector<std::string>& words, Deadline deadline) const;

 private:
  std::filesystem::path folder_;
  ChildProcess server_;
  std::string name_;
};

}  // namespace throng::app
