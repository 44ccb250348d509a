#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/files/input_file.h"

namespace throng {

/// The pages of a table in a database file, read without SQLite, which takes five times as long for each row.
/// It knows tables of plain numbers alone. Where it finds anything else, it says so, and SQLite reads the table.
class TablePages {
 public:
  /// Finds the leaves of the table whose root is page `root`. Returns nothing where the file is unusual.
  static std::optional<TablePages> find(const std::string& file, std::uint32_t root);

  const std::vector<std::uint32_t>& leaves() const { return leaves_; }

  /// Reads the leaves [first, last) and calls visit(values) for each row, with the first columns of the record as
  /// numbers. Returns false where anything is unusual, or `visit` returned false.
  template <typename Visit>
  bool read(std::size_t first, std::size_t last, std::span<double> values, Visit visit) const {
    auto input = InputFile::open(file_);
    if (!input) return false;
    std::string pages;
    while (first < last) {
      const std::size_t run = run_of_pages(first, last);
      if (!read_pages(*input, leaves_[first], run, pages)) return false;
      for (std::size_t i = 0; i < run; ++i) {
        const std::string_view page = std::string_view(pages).substr(i * page_bytes_, usable_bytes_);
        const std::size_t cells = cell_count(page);
        if (cells == 0) return false;
        for (std::size_t cell = 0; cell < cells; ++cell) {
          if (!read_cell(page, cell, values) || !visit()) return false;
        }
      }
      first += run;
    }
    return true;
  }

 private:
  std::size_t run_of_pages(std::size_t first, std::size_t last) const;
  bool read_pages(InputFile& input, std::uint32_t page, std::size_t count, std::string& pages) const;
  bool add_leaves(InputFile& input, std::uint32_t page, int depth);
  /// The number of rows on a leaf; 0 where the page is no leaf.
  static std::size_t cell_count(std::string_view page);
  static bool read_cell(std::string_view page, std::size_t cell, std::span<double> values);

  std::string file_;
  std::size_t page_bytes_ = 0, usable_bytes_ = 0, page_count_ = 0, interior_count_ = 0;
  std::vector<std::uint32_t> leaves_;
};

}  // namespace throng
