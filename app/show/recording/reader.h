#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/show/recording/recording.h"
#include "engine/base/files/input_file.h"
#include "engine/base/result.h"

namespace throng::app {

/// Reads a recording item by item. All values that it returns are checked to be in their ranges.
class RecordingReader {
 public:
  /// Opens a recording, and reads all of it once for its checksum. Errors: the file cannot be read, is no recording, is
  /// of another version, is damaged, or has a malformed header.
  static Result<std::unique_ptr<RecordingReader>> open(const std::filesystem::path& file);

  const RecordingHeader& header() const { return header_; }
  /// Returns the next item, in the order in which it happened. RecordedEnd is the last; after it there is none. Errors:
  /// the file is cut short, or the next item is malformed; then there is none either.
  Result<RecordedItem> next();
  std::uint64_t frames_read() const { return frames_; }
  /// Returns how many frames the file has, as far as it is whole. Reads over all of it, and goes on where it was.
  std::uint64_t count_frames();
  /// Goes back to before the first item.
  void begin_anew();
  /// Returns [agent] the hashes of the last frame that was read.
  std::span<const std::uint16_t> agent_hashes() const { return hashes_; }
  /// Returns "run.rec: frame 12: " and the end of a sentence.
  Error error_at(std::uint64_t frame, const std::string& what) const;

 private:
  RecordingReader(std::filesystem::path file, InputFile input)
      : file_(std::move(file)), input_(std::move(input)), bytes_left_(input_.size()) {}
  std::optional<std::string> read_begin();
  bool is_damaged();
  std::optional<std::uint64_t> hash_of_first(std::uint64_t count);
  bool read_bytes(std::uint64_t count, std::string& bytes);
  std::optional<RecordedItem> item(RecordKind kind);
  std::optional<RecordedItem> frame();
  std::optional<RecordedItem> end() const;
  std::optional<RecordedItem> request();

  std::filesystem::path file_;
  InputFile input_;
  std::uint64_t bytes_left_;
  std::uint64_t bytes_of_items_ = 0;
  RecordingHeader header_;
  Tuning tuning_;  // as of the items read
  std::uint64_t frames_ = 0;
  std::vector<std::uint16_t> hashes_;
  std::string payload_;
};

}  // namespace throng::app
