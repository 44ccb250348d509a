#include "app/files/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace throng::app {
namespace {

namespace fs = std::filesystem;

/// An open file that closes itself.
class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags) : number_(open(file.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (is_open()) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }

  bool write_all(std::string_view contents) const {
    while (!contents.empty()) {
      const ssize_t written = write(number_, contents.data(), contents.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      contents.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

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
  const Descriptor device(file, O_WRONLY);
  if (!device.is_open() || !device.write_all(contents)) return cannot_write(file, errno);
  return anim::Done{};
}

/// Makes the file beside, whole; on failure removes what there is of it.
anim::Status write_beside(const fs::path& beside, const fs::path& file, std::string_view contents) {
  Descriptor part(beside, O_WRONLY | O_CREAT | O_TRUNC);
  if (!part.is_open()) return cannot_write(file, errno);
  if (part.write_all(contents) && part.close()) return anim::Done{};
  const int why = errno;
  unlink(beside.c_str());
  return cannot_write(file, why);
}

}  // namespace

anim::Status write_whole_file(const fs::path& file, std::string_view contents) {
  if (is_device_or_pipe(file)) return write_straight(file, contents);
  const fs::path target = followed(file);
  const fs::path beside = name_beside(target);
  if (anim::Status written = write_beside(beside, file, contents); !written) return written;
  if (rename(beside.c_str(), target.c_str()) == 0) return anim::Done{};
  const int why = errno;
  unlink(beside.c_str());
  return cannot_write(file, why);
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
  if (!Descriptor(beside, O_WRONLY | O_CREAT | O_TRUNC).is_open()) return refuse(errno);
  unlink(beside.c_str());
  return anim::Done{};
}

}  // namespace throng::app
