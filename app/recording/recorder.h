#pragma once

#include <filesystem>
#include <memory>
#include <utility>

#include "app/recording/writer.h"

namespace throng::app {

/// Records into a file while one is open. While none is, it does nothing.
class Recorder {
 public:
  /// Opens a file. Errors: it cannot be written; then nothing has changed.
  anim::Status start(const std::filesystem::path& file, const RecordingHeader& header) {
    auto writer = RecordingWriter::create(file, header);
    if (!writer) return writer.error();
    writer_ = std::move(*writer);
    return anim::Done{};
  }
  /// Finishes the file. Errors: it could not be written. Without an open file there is no error.
  anim::Status stop() { return writer_ == nullptr ? anim::Done{} : std::exchange(writer_, nullptr)->finish(); }
  bool is_recording() const { return writer_ != nullptr; }

  /// Adds an item, as RecordingWriter::add does.
  template <typename... Item>
  void add(const Item&... item) {
    if (writer_ != nullptr) writer_->add(item...);
  }

 private:
  std::unique_ptr<RecordingWriter> writer_;
};

}  // namespace throng::app
