#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/render/result.h"

namespace throng::render {

/// One stage's text with its includes in place. `#line` directives number the files in the order of `files`.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< [0] is the stage's own file
};

/// Reads `file` of `folder` and, in place of each line `#include "name"`, that file of the same folder, once.
Result<ShaderSource> read_shader_source(const std::filesystem::path& folder, const std::string& file);

/// The first complaint of a driver's log as one sentence "name.glsl:12: what", the file taken from `source`.
std::string first_complaint(const std::string& log, const ShaderSource& source);

}  // namespace throng::render
