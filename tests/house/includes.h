#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/house/house_rules.h"

namespace throng::house {

/// A line of a file that includes another. `target` is the path of a header of ours in the tree, else the text.
struct Include {
  const SourceFile* file;
  std::size_t line;
  std::string target;
};

/// Says whether a path is that of a source, a header or a shader.
bool is_code(const std::string& path);

/// Returns the includes of all code below a folder.
std::vector<Include> includes_of(const Tree& tree, std::string_view folder);

/// Returns how many headers of ours each source of app/ takes in, by its path, through all that its headers include.
std::map<std::string, std::size_t> own_headers_behind(const Tree& tree);

}  // namespace throng::house
