#pragma once

#include <functional>
#include <string>

#include "tests/house/house_rules.h"

namespace throng::house {

/// README.md has at most 180 lines of at most 120 characters.
Findings first_page_too_large(const Tree& tree);

/// Every link of a page to another file of the project leads to a file, and to a heading where it names one. `exists`
/// says whether there is a file or folder of that path from the project's folder.
Findings links_that_lead_nowhere(const Tree& tree, const std::function<bool(const std::string&)>& exists);

/// Every file to read that README.md names, such as a model or trajectories, is there. A name in capitals stands for
/// any file. `exists` is as above.
Findings files_to_try_that_are_missing(const Tree& tree, const std::function<bool(const std::string&)>& exists);

}  // namespace throng::house
