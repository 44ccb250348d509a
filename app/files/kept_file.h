#pragma once

#include <filesystem>
#include <string_view>

#include "engine/base/result.h"

namespace throng::app {

/// Returns the folder of the user's own choices: $XDG_CONFIG_HOME/throng, else ~/.config/throng; empty if the system
/// names none.
std::filesystem::path configuration_folder();

/// A file in which a person's choices for a model are kept from run to run: beside the model, or in
/// configuration_folder() where that folder cannot be written, or the character is built in.
class KeptFile {
 public:
  /// `model` is the file of the model; empty for the built-in character. The kept file has its name and `ending`, such
  /// as ".throng.json". Errors call the choices `what` where there is no file to name.
  KeptFile(const std::filesystem::path& model, std::string_view ending, std::string_view what);

  /// Returns the file to read; empty if there is none. Where no file can be written beside the model, a person's own
  /// file goes before the one that came with the model.
  std::filesystem::path found() const;
  /// Writes the file whole or not at all, and returns its path.
  Result<std::filesystem::path> write(std::string_view text) const;

 private:
  std::filesystem::path beside_;  // empty for the built-in character
  std::filesystem::path own_;     // in the user's configuration; empty if the system names none
  std::string_view what_;
};

}  // namespace throng::app
