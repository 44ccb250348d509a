#pragma once

#include <filesystem>
#include <memory>
#include <new>
#include <utility>

#include "app/files/exit_status.h"
#include "app/show/recording/writer.h"

namespace throng::app {

/// Records into a file while one is open. While none is, it does nothing. A file that cannot be written any more is
/// closed, and its error kept.
class Recorder {
 public:
  /// Opens a file. Errors: it cannot be written; then nothing has changed.
  Status start(const std::filesystem::path& file, const RecordingHeader& header) {
    auto writer = RecordingWriter::create(file, header);
    if (!writer) return writer.error();
    writer_ = std::move(*writer);
    outcome_ = Done{};
    return Done{};
  }
  /// Finishes the file. Errors: it could not be written, now or before. Without a file there is no error.
  Status stop() {
    if (writer_ != nullptr) finish();
    return std::exchange(outcome_, Done{});
  }
  bool is_recording() const { return writer_ != nullptr; }
  /// Returns why the file was closed before stop(), if that is so.
  const Status& outcome() const { return outcome_; }

  /// Adds an item, as RecordingWriter::add does.
  template <typename... Item>
  void add(const Item&... item) {
    if (writer_ == nullptr) return;
    has_memory_to([&] { writer_->add(item...); });
    if (writer_->fails()) finish();
  }

 private:
  /// Writes. Returns whether there was memory for it: an item that is half there must not become a whole file.
  template <typename Write>
  bool has_memory_to(const Write& write) {
    try {
      write();
      return true;
    } catch (const std::bad_alloc&) {
      writer_->give_up(sentence_of_failure());
      return false;
    }
  }

  void finish() {
    if (!has_memory_to([this] { outcome_ = writer_->finish(); })) outcome_ = writer_->finish();
    writer_.reset();
  }

  std::unique_ptr<RecordingWriter> writer_;
  Status outcome_ = Done{};
};

}  // namespace throng::app
