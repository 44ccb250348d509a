#pragma once

#include <filesystem>
#include <string_view>

#include "engine/anim/base/result.h"

namespace throng::app {

/// A file in which a person's choices for a model are kept from run to run: beside the model, or in
/// $XDG_CONFIG_HOME/throng (else ~/.config/throng) where that folder cannot be written, or the character is built in.
class KeptFile {
 public:
  /// `model`: its file; empty for the built-in character. `ending`: what is added to the model's name, ".throng.json".
  /// `what`: what errors call the choices where there is no file to name.
  KeptFile(const std::filesystem::path& model, std::string_view ending, std::string_view what);

  /// The file that is to be read; empty if there is none. Where it cannot be kept beside the model, a person's own goes
  /// before the one that came with the model.
  std::filesystem::path found() const;
  /// Written whole or not at all. Where it lies, to tell people.
  anim::Result<std::filesystem::path> write(std::string_view text) const;

 private:
  std::filesystem::path beside_;  // empty for the built-in character
  std::filesystem::path own_;     // in the user's configuration; empty if the system names none
  std::string_view what_;
};

}  // namespace throng::app
