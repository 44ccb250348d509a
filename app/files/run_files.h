#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace throng::app {

/// A file that a run reads or writes, and the option that names it. An empty name stands for no file.
struct NamedFile {
  std::string option;
  std::filesystem::path file;
};

/// All files that a command line names. `-` is standard output.
struct RunFiles {
  std::vector<NamedFile> read, written;
  bool remove_parts = false;  ///< remove remains of killed runs beside files to write

  /// Adds a model, the files that it names, and the file of a person's choices beside it. `model` may be "FILE#SKIN" or
  /// a folder of models; empty is none.
  void read_model(const std::string& model);
};

/// Checks, before the first frame of a run, that it can write its files, and that it reads or writes none of them for
/// another option. Devices and pipes may be named several times.
/// Errors name the option, the file and the other option.
Status check(const RunFiles& files);

/// Names in a line each the remains of killed runs beside the files to write, or removes them and says so.
std::vector<std::string> report_or_remove_parts(const RunFiles& files);

}  // namespace throng::app
