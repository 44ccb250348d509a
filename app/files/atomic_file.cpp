#include "app/files/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include <unistd.h>

namespace throng::app {
namespace {

namespace fs = std::filesystem;

anim::Error cannot_write(const fs::path& file, int error_number) {
  return {file.string() + ": cannot be written: " + std::generic_category().message(error_number)};
}

/// The file that a name stands for, through symbolic links.
fs::path followed(const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  return error ? file : real;
}

fs::path name_beside(const fs::path& file) {
  return file.parent_path() / (file.filename().string() + "." + std::to_string(getpid()) + ".part");
}

bool is_device_or_pipe(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

anim::Status write_straight(const fs::path& file, std::string_view contents) {
  std::FILE* const device = std::fopen(file.c_str(), "wbe");
  if (device == nullptr) return cannot_write(file, errno);
  const bool written = std::fwrite(contents.data(), 1, contents.size(), device) == contents.size();
  if (std::fclose(device) != 0 || !written) return cannot_write(file, errno);
  return anim::Done{};
}

}  // namespace

anim::Status write_whole_file(const fs::path& file, std::string_view contents) {
  if (is_device_or_pipe(file)) return write_straight(file, contents);
  auto part = FileBeside::create(file);
  if (!part) return part.error();
  part->write(contents);
  anim::Status written = part->commit();
  if (!written) unlink(name_beside(part->file()).c_str());
  return written;
}

anim::Result<FileBeside> FileBeside::create(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) return cannot_write(file, EISDIR);
  if (is_device_or_pipe(file)) return anim::Error{file.string() + ": must be a file, not a device or pipe"};
  fs::path target = followed(file);
  fs::path beside = name_beside(target);
  std::FILE* const stream = std::fopen(beside.c_str(), "wbe");
  if (stream == nullptr) return cannot_write(file, errno);
  return FileBeside(std::move(target), std::move(beside), stream);
}

FileBeside::FileBeside(FileBeside&& other) noexcept
    : file_(std::move(other.file_)),
      beside_(std::move(other.beside_)),
      stream_(std::exchange(other.stream_, nullptr)),
      error_(other.error_) {}

FileBeside::~FileBeside() {
  if (stream_ != nullptr) std::fclose(stream_);
}

void FileBeside::write(std::string_view contents) {
  if (error_ != 0) return;
  if (std::fwrite(contents.data(), 1, contents.size(), stream_) != contents.size()) error_ = errno;
}

anim::Status FileBeside::commit() {
  const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
  if (!closed && error_ == 0) error_ = errno;
  if (error_ == 0 && rename(beside_.c_str(), file_.c_str()) != 0) error_ = errno;
  if (error_ == 0) return anim::Done{};
  return cannot_write(file_, error_);
}

anim::Status write_output(const std::string& file, std::string_view contents) {
  if (file != "-") return write_whole_file(file, contents);
  const bool written = std::fwrite(contents.data(), 1, contents.size(), stdout) == contents.size();
  if (!written || std::fflush(stdout) != 0) return cannot_write("standard output", errno);
  return anim::Done{};
}

anim::Status check_can_be_written(std::string_view option, const fs::path& file) {
  const auto refuse = [&](int why) -> anim::Status {
    return anim::Error{std::string(option) + " " + cannot_write(file, why).message};
  };
  std::error_code error;
  if (fs::is_directory(file, error)) return refuse(EISDIR);
  if (is_device_or_pipe(file)) return access(file.c_str(), W_OK) == 0 ? anim::Status(anim::Done{}) : refuse(errno);
  const fs::path beside = name_beside(followed(file));
  std::FILE* const part = std::fopen(beside.c_str(), "wbe");
  if (part == nullptr) return refuse(errno);
  std::fclose(part);
  unlink(beside.c_str());
  return anim::Done{};
}

}  // namespace throng::app
