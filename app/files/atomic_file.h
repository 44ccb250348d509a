#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "engine/anim/base/result.h"

namespace throng::app {

/// Writes `contents` beside `file` under a temporary name and renames it. So `file` is whole or as it was, also when
/// two programs write it at once. A device or pipe is written directly; a symbolic link is followed.
anim::Status write_whole_file(const std::filesystem::path& file, std::string_view contents);

/// Does the same; `-` means standard output.
anim::Status write_output(const std::string& file, std::string_view contents);

/// A file that is written as its contents come, beside its place under a temporary name, FILE.PID.part. commit()
/// renames it when it is whole; without commit() the part stays where it is. It does not write to devices and pipes.
class FileBeside {
 public:
  static anim::Result<FileBeside> create(const std::filesystem::path& file);
  FileBeside(FileBeside&& other) noexcept;
  FileBeside& operator=(FileBeside&&) = delete;
  ~FileBeside();

  /// Writes more of the file. commit() returns the error if one goes wrong.
  void write(std::string_view contents);
  anim::Status commit();
  const std::filesystem::path& file() const { return file_; }

 private:
  FileBeside(std::filesystem::path file, std::filesystem::path beside, std::FILE* stream)
      : file_(std::move(file)), beside_(std::move(beside)), stream_(stream) {}

  std::filesystem::path file_, beside_;
  std::FILE* stream_;  // null after commit()
  int error_ = 0;      // the error of the first write that failed
};

/// Checks that write_whole_file() could write there now, so that a long run does not fail at its end. Leaves no file.
/// `option` begins the sentence of the error.
anim::Status check_can_be_written(std::string_view option, const std::filesystem::path& file);

}  // namespace throng::app
