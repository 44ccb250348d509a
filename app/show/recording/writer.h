#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/byte_hash.h"
#include "app/show/recording/recording.h"
#include "engine/base/files/output_file.h"
#include "engine/base/result.h"

namespace throng::app {

/// Writes a recording as it happens, into FILE.PID.part; finish() renames it to FILE. After a crash or an error the
/// part remains, and can be replayed as far as it goes.
class RecordingWriter {
 public:
  /// Opens the file. Errors: it cannot be written.
  static Result<std::unique_ptr<RecordingWriter>> create(const std::filesystem::path& file,
                                                         const RecordingHeader& header);

  /// Adds a request that was taken.
  void add(const CrowdRequest& request);
  /// Adds a frame after its update. `agent_hashes` are those of AnimatedCrowd. Allocates only when the crowd grows.
  void add(const RecordedFrame& frame, std::span<const std::uint64_t> agent_hashes);

  /// Writes nothing more, and lets finish() say why.
  void give_up(std::string_view why) { state_ = Error{file().string() + ": cannot be written: " + std::string(why)}; }
  /// Returns whether a part of the file could not be written; then nothing more is.
  bool fails() const { return !state_; }
  /// Gives the file, which is whole, its name. Errors: a part of it could not be written. The error says where the
  /// frames before that are.
  Status finish();
  const std::filesystem::path& file() const { return file_.file(); }

 private:
  explicit RecordingWriter(OutputFile file, const Tuning& tuning) : file_(std::move(file)), tuning_(tuning) {}
  void write(std::string_view bytes);
  void write_item(RecordKind kind);
  void add_changed_hashes(std::span<const std::uint64_t> agent_hashes);

  OutputFile file_;
  ByteHash written_;
  Tuning tuning_;  // as it was written last
  std::uint64_t frames_ = 0;
  Status state_ = Done{};
  std::vector<std::uint16_t> hashes_;  // [agent] as they were written last
  std::string payload_;                // used again and again
};

}  // namespace throng::app
