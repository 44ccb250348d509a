#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "throng/result.h"

namespace throng::render {

/// Says something about a picture inside its PNG (a chunk tEXt): a keyword of 1 to 79 letters, and its text.
struct PngText {
  std::string keyword;
  std::string text;

  friend bool operator==(const PngText&, const PngText&) = default;
};

/// Returns the texts that stand in a PNG before its pixels; none where it has none. Errors: it cannot be read, or it is
/// no PNG.
Result<std::vector<PngText>> read_png_texts(const std::filesystem::path& file);

}  // namespace throng::render
