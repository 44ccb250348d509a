#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace throng::render {

/// Says from which file and line a line of a ShaderSource comes.
struct ShaderLine {
  std::size_t file = 0;    ///< index among ShaderSource::files
  std::size_t number = 1;  ///< counted from 1
};

/// Holds the text of one stage with its includes in place. Drivers disagree on `#line`, so it maps lines back itself.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< [0] is the stage's own file
  std::vector<ShaderLine> lines;   ///< one a line of text
};

/// Reads `file` of `folder`, and puts each file that it includes in the place of the first line that asks for it.
/// Defines each of `switches` after its first line, which must say the version.
Result<ShaderSource> read_shader_source(const std::filesystem::path& folder, const std::string& file,
                                        const std::vector<std::string>& switches = {});

/// Gives the first message of a driver's log as one sentence, "name.glsl:12: message"; `source` knows the file.
std::string first_complaint(const std::string& log, const ShaderSource& source);

}  // namespace throng::render
