#include "engine/tracks/text_rows.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <span>
#include <utility>

#include "engine/anim/bake/parallel.h"
#include "engine/base/files/input_file.h"
#include "engine/tracks/progress_clock.h"
#include "engine/tracks/reading_threads.h"

namespace throng {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 20U;

/// A piece of the text that ends with a line.
struct TextBlock {
  std::string text;
  std::size_t number = 0;
  std::size_t first_line = 1;
  double share = 0.0;  ///< of the file that is read with it
};

/// Hands the text of a file out in blocks, to any thread.
class BlockSource {
 public:
  BlockSource(InputFile file, std::size_t done, std::size_t line) : file_(std::move(file)), done_(done), line_(line) {}

  /// Fills the next block. Returns false at the end, or after an error.
  bool next(TextBlock& block) {
    const std::lock_guard lock(mutex_);
    if (is_over_) return false;
    block.text.swap(rest_);
    rest_.clear();
    const std::size_t old = block.text.size();
    block.text.resize(old + block_bytes);
    const auto read = file_.read(std::as_writable_bytes(std::span(block.text)).subspan(old));
    if (!read) return end(read.error());
    block.text.resize(old + *read);
    done_ += *read;
    const bool is_last = *read < block_bytes;
    is_over_ = is_last;
    if (!is_last) {
      const std::size_t newline = block.text.rfind('\n');
      if (newline == std::string::npos) {
        return end(Error{"line " + std::to_string(line_) + ": it is longer than 1 MiB; name a file with a row a line"});
      }
      rest_.assign(block.text, newline + 1);
      block.text.resize(newline + 1);
    }
    block.number = count_++;
    block.first_line = line_;
    block.share = file_.size() == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(file_.size());
    line_ += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
    return !block.text.empty();
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  const Status& status() const { return status_; }

 private:
  bool end(Error error) {
    is_over_ = true;
    status_ = std::move(error);
    return false;
  }

  std::mutex mutex_;
  InputFile file_;
  std::string rest_;  // of the last block: the beginning of a line
  std::size_t done_, line_, count_ = 0;
  bool is_over_ = false;
  Status status_ = Done{};
};

/// Holds the result of reading a block.
struct ReadBlock {
  std::size_t number = 0;
  RowBlock rows;
  std::size_t bad = 0;
  std::string first_bad;
  bool is_refused = false;  ///< for `first_bad`
};

/// Reads the lines of a block. Stops at a bad line, unless bad lines are skipped.
void read_lines(const TextBlock& block, bool is_lenient, LineParser& parser, RowSink& sink, ReadBlock& read) {
  const char* at = block.text.data();
  const char* const end = at + block.text.size();
  sink.rows.clear();
  for (std::size_t line = block.first_line; at < end; ++line) {
    const void* const found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    const char* const stop = found == nullptr ? end : static_cast<const char*>(found);
    const std::size_t rows = sink.rows.size();
    if (!parser.read({at, static_cast<std::size_t>(stop - at)}, sink)) {
      sink.rows.resize(rows);
      if (read.bad++ == 0) read.first_bad = "line " + std::to_string(line) + ": " + sink.fault;
      if (!is_lenient) {
        read.is_refused = true;
        break;
      }
    }
    at = stop + 1;
  }
  read.rows.rows = take_rows_of(sink);
}

}  // namespace

Error row_error(const std::string& file, const std::string& fault) {
  return {file + ": " + fault + ", or skip such rows with --lenient"};
}

Error too_many_people(const std::string& file) {
  return {file + ": it has more than 100,000 people; cut it into parts, in time or place"};
}

Result<std::string> read_head(const std::string& file) {
  auto input = InputFile::open(file, "a file of trajectories");
  if (!input) return Error{file + ": " + input.error().message};
  std::string head(head_bytes, '\0');
  const auto read = input->read(std::as_writable_bytes(std::span(head)));
  if (!read) return Error{file + ": " + read.error().message};
  head.resize(*read);
  if (*read < head_bytes) return head;
  const std::size_t newline = head.rfind('\n');
  if (newline != std::string::npos) head.resize(newline + 1);
  return head;
}

Status read_rows(const std::string& file, const TextFormat& format, const TrackReading& options,
                 const ReadProgress& progress, RawTracks& tracks) {
  auto input = InputFile::open(file, "a file of trajectories");
  if (!input) return Error{file + ": " + input.error().message};
  if (const Status moved = input->go_to(format.body); !moved) return Error{file + ": " + moved.error().message};
  const bool is_small = input->size() < 2 * block_bytes;
  BlockSource source(std::move(*input), format.body, format.body_line);
  const std::size_t thread_count = is_small ? 1 : reading_threads();
  std::vector<RowSink> sinks(thread_count);
  std::vector<std::vector<ReadBlock>> read(thread_count);
  const auto work = [&](std::size_t thread) {
    const std::unique_ptr<LineParser> parser = format.parser->copy();
    ProgressClock clock(progress);
    RowSink& sink = sinks[thread];
    sink.most = most_metres / options.metres_a_unit.value_or(format.facts.unit.value_or(1.0));
    for (TextBlock block; source.next(block);) {
      ReadBlock& done = read[thread].emplace_back();
      done.number = block.number;
      done.rows.table = thread;
      read_lines(block, options.lenient, *parser, sink, done);
      if (done.is_refused || sink.ids.size() > most_people) source.stop();
      if (thread == 0) clock.show(block.share);
    }
  };
  anim::in_parallel(thread_count, work);

  std::vector<ReadBlock> blocks;
  for (std::size_t thread = 0; thread < thread_count; ++thread) {
    std::ranges::move(read[thread], std::back_inserter(blocks));
    tracks.scene_rate = std::max(tracks.scene_rate, sinks[thread].scene_rate);
    tracks.tables.push_back(std::move(sinks[thread].ids));
  }
  std::ranges::sort(blocks, {}, &ReadBlock::number);
  for (ReadBlock& block : blocks) {
    if (block.is_refused) return row_error(file, block.first_bad);
    if (tracks.bad_rows == 0 && block.bad > 0) tracks.first_bad_row = block.first_bad;
    tracks.bad_rows += block.bad;
    tracks.blocks.push_back(std::move(block.rows));
  }
  if (!source.status()) return Error{file + ": " + source.status().error().message};
  return Done{};
}

}  // namespace throng
