#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace throng::app {

/// Lines of cells, whose columns stand below each other.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> headings) : lines_{std::move(headings)} {}

  void add(std::vector<std::string> cells) { lines_.push_back(std::move(cells)); }
  bool is_empty() const { return lines_.size() == 1; }

  /// Returns the lines, each after `indent` spaces. The first column stands left; cells that begin with a digit, and
  /// the headings of such cells, stand right.
  std::string text(std::size_t indent) const;

 private:
  bool heads_numbers(std::size_t column) const;

  std::vector<std::vector<std::string>> lines_;  ///< headings first
};

}  // namespace throng::app
