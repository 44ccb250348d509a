#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/render/result.h"

namespace throng::render {

/// Where a line of a ShaderSource was written.
struct ShaderLine {
  std::size_t file = 0;    ///< index among ShaderSource::files
  std::size_t number = 1;  ///< counted from 1
};

/// One stage's text with its includes in place. (Drivers disagree on `#line`, so lines are mapped back here.)
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< [0] is the stage's own file
  std::vector<ShaderLine> lines;   ///< one a line of text
};

/// Reads `file` of `folder` and, in place of each line `#include "name"`, that file of the same folder, once.
Result<ShaderSource> read_shader_source(const std::filesystem::path& folder, const std::string& file);

/// The first complaint of a driver's log as one sentence "name.glsl:12: what", the file taken from `source`.
std::string first_complaint(const std::string& log, const ShaderSource& source);

}  // namespace throng::render
