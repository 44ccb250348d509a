#include "engine/tracks/page_rows.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/anim/bake/parallel.h"
#include "engine/tracks/progress_clock.h"
#include "engine/tracks/reading_threads.h"
#include "engine/tracks/table_pages.h"

namespace throng {
namespace {

constexpr std::size_t leaves_a_block = 2048;  // whose rows fill huge pages

/// Where the columns of a row lie in a record.
struct RowColumns {
  std::size_t frame = 0, id = 0, x = 0, y = 0, direction_x = 0, direction_y = 0;
  bool has_direction = false;
  std::size_t count = 0;  ///< of columns up to the last one that is read
};

RowColumns columns_of(const Database::Table& table) {
  RowColumns columns;
  const auto find = [&](const char* name, std::size_t& at) {
    at = static_cast<std::size_t>(std::ranges::find(table.columns, name) - table.columns.begin());
    if (at < table.columns.size()) columns.count = std::max(columns.count, at + 1);
    return at < table.columns.size();
  };
  find("frame", columns.frame);
  find("id", columns.id);
  find("pos_x", columns.x);
  find("pos_y", columns.y);
  const bool has_x = find("ori_x", columns.direction_x), has_y = find("ori_y", columns.direction_y);
  columns.has_direction = has_x && has_y;
  return columns;
}

/// Gives numbers to ids that are small whole numbers without making texts of them.
class WholeIds {
 public:
  explicit WholeIds(IdTable& ids) : ids_(ids) {}

  /// Returns false if the id is no whole number.
  bool take(double id, std::uint32_t& number) {
    if (!(std::abs(id) < 9e15) || id != std::floor(id)) return false;
    const auto whole = static_cast<std::int64_t>(id);
    if (whole < 0 || whole >= 1'000'000) {
      number = ids_.number_of(whole);
      return true;
    }
    const auto at = static_cast<std::size_t>(whole);
    if (at >= known_.size()) known_.resize(at + 1, 0);
    if (known_[at] == 0) known_[at] = ids_.number_of(whole) + 1;
    number = known_[at] - 1;
    return true;
  }

 private:
  IdTable& ids_;
  std::vector<std::uint32_t> known_;  // by id: a number and 1, or 0
};

/// Holds the rows that one thread read.
struct PagePart {
  RowSink sink;
  std::vector<std::pair<std::size_t, RowBlock>> blocks;  ///< with the first leaf of each
};

bool take_row(const std::array<double, 16>& values, const RowColumns& columns, WholeIds& ids, RowSink& sink) {
  RawRow row{.time = values[columns.frame], .x = values[columns.x], .y = values[columns.y]};
  if (!std::isfinite(row.time) || !std::isfinite(row.x) || !std::isfinite(row.y)) return false;
  if (columns.has_direction) {
    const double x = values[columns.direction_x], y = values[columns.direction_y];
    if (!std::isfinite(x) || !std::isfinite(y)) return false;
    row.angle = heading_of_direction(x, y);
  }
  return ids.take(values[columns.id], row.person) && add_row(row, sink);
}

}  // namespace

bool read_page_rows(const std::string& file, const Database::Table& table, const TrackReading& options,
                    const ReadProgress& progress, RawTracks& tracks) {
  const RowColumns columns = columns_of(table);
  std::array<double, 16> empty{};
  if (!table.is_plain || columns.count > empty.size()) return false;
  const auto pages = TablePages::find(file, table.root_page);
  if (!pages) return false;
  const std::size_t leaf_count = pages->leaves().size();
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> is_usual = true;
  const std::size_t threads = leaf_count < leaves_a_block ? 1 : reading_threads();
  std::vector<PagePart> parts(threads);
  anim::in_parallel(threads, [&](std::size_t thread) {
    PagePart& part = parts[thread];
    WholeIds ids(part.sink.ids);
    part.sink.most = most_metres / options.metres_a_unit.value_or(1.0);
    ProgressClock clock(progress);
    std::array<double, 16> values{};
    for (;;) {
      const std::size_t first = next.fetch_add(leaves_a_block);
      if (first >= leaf_count || !is_usual) return;
      const std::size_t last = std::min(first + leaves_a_block, leaf_count);
      const bool is_read = pages->read(first, last, std::span(values).first(columns.count),
                                       [&] { return take_row(values, columns, ids, part.sink); });
      if (!is_read || part.sink.ids.size() > most_people) is_usual = false;
      part.blocks.emplace_back(first, RowBlock{take_rows_of(part.sink), thread});
      if (thread == 0) clock.show(static_cast<double>(last) / static_cast<double>(leaf_count));
    }
  });
  if (!is_usual) return false;
  std::vector<std::pair<std::size_t, RowBlock>> blocks;
  for (PagePart& part : parts) {
    std::ranges::move(part.blocks, std::back_inserter(blocks));
    tracks.tables.push_back(std::move(part.sink.ids));
  }
  std::ranges::sort(blocks, {}, [](const auto& block) { return block.first; });
  for (auto& block : blocks) tracks.blocks.push_back(std::move(block.second));
  return true;
}

}  // namespace throng
