#include "app/files/nearest_names.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

// Counts the insertions, deletions and exchanges that make one name the other (Levenshtein); case does not count.
std::size_t difference(std::string_view a, std::string_view b) {
  const auto lower = [](char letter) { return letter >= 'A' && letter <= 'Z' ? letter - 'A' + 'a' : int{letter}; };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (lower(letter) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_names(std::string_view wanted, std::span<const std::string> names) {
  constexpr std::size_t most = 3;
  std::vector<std::string> nearest(names.begin(), names.end());
  std::ranges::stable_sort(nearest, {}, [&](const std::string& name) { return difference(wanted, name); });
  nearest.resize(std::min(nearest.size(), most));
  return joined(nearest);
}

std::optional<std::string> name_meant(std::string_view wanted, std::span<const std::string> names) {
  const auto nearest = std::ranges::min_element(names, {}, [&](const auto& name) { return difference(wanted, name); });
  if (nearest == names.end() || 3 * difference(wanted, *nearest) > nearest->size() + 2) return {};
  return *nearest;
}

}  // namespace throng::app
