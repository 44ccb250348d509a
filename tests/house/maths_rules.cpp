#include "tests/house/maths_rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <string_view>

namespace throng::house {
namespace {

constexpr std::array<std::string_view, 4> free_to_call{"engine/anim/lod/", "engine/anim/examples/",
                                                       "engine/anim/bake/skip_error.cpp",
                                                       "engine/anim/survey/placement_guess.cpp"};

}  // namespace

// GLM's mix() is not among these calls: mix() of vectors is exact, and no source of engine/anim mixes quaternions with
// it.
Findings rounded_by_the_system(const Tree& tree) {
  static const std::regex calls(
      R"((^|[^\w.>])(a?(sin|cos|tan)h?|atan2|sincos|exp2?|expm1|log(2|10|1p|b)?|pow|hypot|cbrt)[fl]?\()"
      R"(|\bglm::(angleAxis|angle|axis|slerp|rotate\w*|orient\w+|euler\w*|pitch|yaw|roll|polar|euclidean|perspective\w*)\b)");
  Findings findings;
  for (const SourceFile& file : tree) {
    const auto starts = [&file](std::string_view folder) { return file.path.starts_with(folder); };
    const bool is_code = file.path.ends_with(".h") || file.path.ends_with(".cpp");
    if (!is_code || !starts("engine/anim/") || std::ranges::any_of(free_to_call, starts)) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      if (!std::regex_search(line.begin(),
                             line.begin() + static_cast<std::ptrdiff_t>(std::min(line.find("//"), line.size())), calls))
        continue;
      findings.push_back(file.path + ":" + std::to_string(i + 1) +
                         ": each system rounds it otherwise; see base/elementary.h");
    }
  }
  return findings;
}

}  // namespace throng::house
