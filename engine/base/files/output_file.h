#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace throng {

/// A file that is written. No other code of the project opens files to write them.
///
/// The contents go beside their place, into FILE.PID.part, which commit() renames: FILE is whole or as it was, also
/// when two programs write it at once. A link is followed, and the file's mode is kept. A device or a pipe is written
/// straight. Errors are sentences that begin with the file's name.
class OutputFile {
 public:
  enum class Unfinished { removed, kept };  ///< the fate of a part without commit(); an empty part is removed
  enum class Sync { disk, system };         ///< whether commit() waits until the disk has the file

  /// Begins a file. `expected` is the count of its bytes, if known: the error of a full disk then says what is missing.
  static Result<OutputFile> create(const std::filesystem::path& file, Unfinished unfinished = Unfinished::removed,
                                   std::uint64_t expected = 0);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// Writes more of the file. After the first error, nothing more is written, and each call returns that error.
  Status write(std::string_view contents);
  /// Writes what is left, and gives the file its name.
  Status commit(Sync sync = Sync::disk);
  const std::filesystem::path& file() const { return file_; }
  const std::filesystem::path& part() const { return part_; }  ///< empty for a device or a pipe
  /// Returns the error of a full disk, if the words of another program that writes the part tell of one.
  std::optional<Error> full_disk_in(std::string_view words) const;

 private:
  OutputFile(std::filesystem::path file, Unfinished unfinished, std::uint64_t expected);
  Status open_straight();
  Status open_part();
  Status fail(int error_number);
  Status flush();

  std::filesystem::path file_, part_;
  std::string pending_;  // bytes that are not written yet
  int descriptor_ = -1;  // -1 before it is open and after commit()
  Unfinished unfinished_;
  std::uint64_t expected_, written_ = 0;
  Status state_ = Done{};
};

/// Returns whether there is a device, a pipe or a socket, which is written straight.
bool is_device_or_pipe(const std::filesystem::path& file);

/// Writes all of a file. A file of which a part could not be written is as it was.
Status write_whole_file(const std::filesystem::path& file, std::string_view contents,
                        OutputFile::Sync sync = OutputFile::Sync::disk);

/// Writes as write_whole_file() does; `-` means standard output.
Status write_output(const std::string& file, std::string_view contents);

/// Writes a text for people to standard output.
Status print(std::string_view text);

/// Checks that write_whole_file() could write there now, so that a long run does not fail at its end. Leaves no file.
/// `option` begins the sentence of the error.
Status check_can_be_written(std::string_view option, const std::filesystem::path& file);

/// Returns the parts that runs left beside `file` when they were killed.
std::vector<std::filesystem::path> parts_left_beside(const std::filesystem::path& file);

}  // namespace throng
