#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "throng/character.h"

#include "engine/anim/import/memory/memory_account.h"

namespace throng::import {

/// A model, and where the files are that it names.
struct ModelSource {
  std::filesystem::path path;                ///< of the model; for messages alone where files are in memory
  std::span<const FileInMemory> files = {};  ///< in place of files of the disk: the model, and what it names
  bool strict = false;                       ///< takes a uri by its letter alone, and follows no link out of the folder
};

/// Reads the files that a model names. They are in memory, or they lie below the folder in which the model is found, or
/// below the one in which it lies if its own name is a link.
///
/// A uri never leads out of a folder by itself: absolute paths, schemes and ".." are refused. A symbolic link in the
/// folder leads where the operating system says, because the folder's owner put it there; model hubs and build systems
/// lay out every file as a link.
class ModelFiles {
 public:
  explicit ModelFiles(const ModelSource& source = {});

  /// Returns the file that a uri names, always by the same path, or none for a data URI. Where no file has the name
  /// that the uri says, one is found whose name differs by escapes, backslashes, a query or the case of letters;
  /// `repairs` says so of `object`, which names it. Throws Refusal, with the name of the file that is missing.
  std::filesystem::path find(std::string_view uri, const std::string& object, std::vector<std::string>& repairs) const;

  /// Returns the bytes of a file that was found, or of the data URI if there is none, and charges `memory` with them.
  /// Throws Refusal.
  std::vector<std::byte> read(std::string_view uri, const std::filesystem::path& file, const std::string& object,
                              MemoryAccount& memory);

 private:
  std::set<std::filesystem::path> counted_;  // files whose size the account knows
  std::vector<std::filesystem::path> folders_;
  std::span<const FileInMemory> files_;
  bool strict_;
};

}  // namespace throng::import
