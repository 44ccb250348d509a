#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/anim/import/import.h"

namespace throng::import::testing {

/// What became of an import in a process of its own.
struct ImportApart {
  std::string message;     ///< why it was refused, or empty
  std::uint64_t peak = 0;  ///< bytes that it held at a time, measured
};

ImportApart import_apart(const std::filesystem::path& file, const ImportOptions& options = {});

}  // namespace throng::import::testing
