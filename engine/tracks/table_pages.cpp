#include "engine/tracks/table_pages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace throng {
namespace {

constexpr int deepest_tree = 12;
constexpr char interior_page = 0x05, leaf_page = 0x0D;

std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Returns the eight bytes at `at` as a number whose first byte is the highest.
std::uint64_t eight_bytes(std::string_view page, std::size_t at) {
  std::uint64_t word = 0;
  std::memcpy(&word, page.data() + at, sizeof(word));
  if constexpr (std::endian::native == std::endian::big) return word;
  constexpr std::uint64_t bytes = 0x00FF00FF00FF00FFU, pairs = 0x0000FFFF0000FFFFU;
  word = (word >> 8U & bytes) | (word & bytes) << 8U;  // compilers make one instruction of it
  word = (word >> 16U & pairs) | (word & pairs) << 16U;
  return word >> 32U | word << 32U;
}

/// Reads a number of one to nine bytes, as SQLite writes them, and goes past it. Returns false beyond the page.
bool take_varint(std::string_view page, std::size_t& at, std::uint64_t& value) {
  if (at < page.size() && static_cast<unsigned char>(page[at]) < 0x80) {
    value = static_cast<unsigned char>(page[at++]);
    return true;
  }
  value = 0;
  for (int i = 0; i < 9 && at < page.size(); ++i) {
    const auto byte = static_cast<unsigned char>(page[at++]);
    if (i == 8) {
      value = value << 8U | byte;
      return true;
    }
    value = value << 7U | (byte & 0x7FU);
    if (byte < 0x80) return true;
  }
  return false;
}

/// The bytes that a number of a kind takes in a record; more than 8: it is no number.
std::size_t bytes_of_kind(std::uint64_t kind) {
  static constexpr std::array<std::size_t, 10> sizes{99, 1, 2, 3, 4, 6, 8, 8, 0, 0};
  return kind < sizes.size() ? sizes[kind] : 99;
}

double number_of_kind(std::uint64_t kind, std::string_view page, std::size_t at) {
  if (kind >= 8) return kind == 9 ? 1.0 : 0.0;
  const std::size_t count = bytes_of_kind(kind);
  const auto unused = static_cast<unsigned>(64 - 8 * count);
  // Most numbers are followed by others, so that eight bytes can be read at once.
  const std::uint64_t bits = at + 8 <= page.size() ? eight_bytes(page, at) : big_endian(page, at, count) << unused;
  if (kind == 7) return std::bit_cast<double>(bits);
  return static_cast<double>(static_cast<std::int64_t>(bits) >> unused);
}

}  // namespace

std::optional<TablePages> TablePages::find(const std::string& file, std::uint32_t root) {
  auto input = InputFile::open(file);
  if (!input) return {};
  std::array<char, 100> header{};
  const auto read = input->read(std::as_writable_bytes(std::span(header)));
  if (!read || *read < header.size()) return {};
  const std::string_view text(header.data(), header.size());
  TablePages pages;
  pages.file_ = file;
  pages.page_bytes_ = big_endian(text, 16, 2) == 1 ? 65536 : big_endian(text, 16, 2);
  const std::size_t reserved = big_endian(text, 20, 1);
  if (pages.page_bytes_ < 512 || !std::has_single_bit(pages.page_bytes_) || reserved > 32) return {};
  pages.usable_bytes_ = pages.page_bytes_ - reserved;
  pages.page_count_ = input->size() / pages.page_bytes_;
  if (!pages.add_leaves(*input, root, 0)) return {};
  return pages;
}

bool TablePages::add_leaves(InputFile& input, std::uint32_t page, int depth) {
  std::string text;
  if (depth == deepest_tree || page < 2 || !read_pages(input, page, 1, text)) return false;
  if (text[0] == leaf_page) {
    leaves_.push_back(page);
    return leaves_.size() <= page_count_;
  }
  if (text[0] != interior_page || ++interior_count_ > page_count_) return false;
  const std::size_t cells = big_endian(text, 3, 2);
  if (12 + cells * 2 > usable_bytes_) return false;
  std::string child;
  // Either all children are leaves or none is, so one of them decides.
  for (std::size_t i = 0; i <= cells; ++i) {
    const std::size_t at = i == cells ? 8 : big_endian(text, 12 + 2 * i, 2);
    if (at + 4 > usable_bytes_) return false;
    const auto next = static_cast<std::uint32_t>(big_endian(text, at, 4));
    if (i == 0 && !read_pages(input, next, 1, child)) return false;
    if (child[0] == leaf_page) {
      if (next < 2 || next > page_count_) return false;
      leaves_.push_back(next);
      if (leaves_.size() > page_count_) return false;
    } else if (!add_leaves(input, next, depth + 1)) {
      return false;
    }
  }
  return true;
}

std::size_t TablePages::run_of_pages(std::size_t first, std::size_t last) const {
  const std::size_t most = std::max<std::size_t>(1, (std::size_t{256} << 10U) / page_bytes_);
  std::size_t run = 1;
  while (run < most && first + run < last && leaves_[first + run] == leaves_[first] + run) ++run;
  return run;
}

bool TablePages::read_pages(InputFile& input, std::uint32_t page, std::size_t count, std::string& pages) const {
  if (page == 0 || page - 1 + count > page_count_) return false;
  pages.resize(count * page_bytes_);
  if (!input.go_to((page - 1) * static_cast<std::uint64_t>(page_bytes_))) return false;
  const auto read = input.read(std::as_writable_bytes(std::span(pages)));
  return read && *read == pages.size();
}

std::size_t TablePages::cell_count(std::string_view page) {
  if (page[0] != leaf_page) return 0;
  const std::size_t cells = big_endian(page, 3, 2);
  return 8 + 2 * cells <= page.size() ? cells : 0;
}

bool TablePages::read_cell(std::string_view page, std::size_t cell, std::span<double> values) {
  std::size_t at = big_endian(page, 8 + 2 * cell, 2);
  std::uint64_t bytes = 0, rowid = 0, header = 0;
  if (!take_varint(page, at, bytes) || !take_varint(page, at, rowid)) return false;
  // A record that goes on on another page is longer than rows of numbers are.
  if (bytes > page.size() || at + bytes > page.size()) return false;
  const std::size_t record = at, end = at + static_cast<std::size_t>(bytes);
  if (!take_varint(page, at, header) || header > bytes) return false;
  const std::size_t kinds_end = record + static_cast<std::size_t>(header);
  std::size_t body = kinds_end;
  for (double& value : values) {
    std::uint64_t kind = 0;
    if (at >= kinds_end || !take_varint(page, at, kind)) return false;
    const std::size_t size = bytes_of_kind(kind);
    if (size > 8 || body + size > end) return false;
    value = number_of_kind(kind, page, body);
    body += size;
  }
  return true;
}

}  // namespace throng
