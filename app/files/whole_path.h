#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "engine/base/text/plain_text.h"

namespace throng::app {

/// Returns the path of a file from the root on, as a message shows it.
inline std::string whole_path(const std::filesystem::path& file) {
  std::error_code failed;
  const std::filesystem::path whole = std::filesystem::absolute(file, failed);
  return plain_text((failed ? file : whole).lexically_normal().string());
}

}  // namespace throng::app
