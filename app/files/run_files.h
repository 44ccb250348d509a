#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/anim/base/result.h"

namespace throng::app {

/// A file that a run reads or writes, and the option that names it. An empty file is none.
struct NamedFile {
  std::string option;
  std::filesystem::path file;
};

/// All files that a command line names. `-` is standard output.
struct RunFiles {
  std::vector<NamedFile> read, written;
  bool remove_parts = false;  ///< what killed runs left beside those to be written

  /// Adds a model, the files that it names, and what people chose for it, which lies beside it. `model` may be
  /// "FILE#SKIN" or a folder of models; empty is none.
  void read_model(const std::string& model);
};

/// Checks, before its first frame and not after its last, that a run can write its files, and that none of them is one
/// that it reads or writes for another option. Devices and pipes may be named several times.
/// Errors name the option, the file and the other option.
anim::Status check(const RunFiles& files);

/// Says in a line each what earlier runs left beside the files to be written when they were killed, or that it is
/// removed now.
std::vector<std::string> tend_to_parts(const RunFiles& files);

}  // namespace throng::app
