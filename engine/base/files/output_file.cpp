#include "engine/base/files/output_file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <span>
#include <system_error>
#include <utility>

#include "engine/base/files/output_calls.h"
#include "engine/base/files/process.h"
#include "engine/base/text/size_text.h"

namespace throng {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_pending = 65536;
constexpr std::string_view part_ending = ".part";

Error cannot_write(const fs::path& file, const std::string& why) {
  return {file.string() + ": cannot be written: " + why};
}
Error cannot_write(const fs::path& file, int error_number) {
  const std::string remedy = error_number == ENOENT ? "; make its folder, or name another file" : "";
  return cannot_write(file, std::generic_category().message(error_number) + remedy);
}

/// Returns the file that a name stands for, through links, also where that file does not exist yet.
fs::path followed(fs::path file) {
  constexpr int most_links = 40;  // as the kernel has it
  std::error_code error;
  for (int link = 0; link < most_links && fs::is_symlink(fs::symlink_status(file, error)); ++link) {
    file = (file.parent_path() / fs::read_symlink(file, error)).lexically_normal();
  }
  return file;
}

/// Returns the name of a part, shorter than the system's limit: "run.rec.1234.part", and "run.rec.1234-1.part" next.
fs::path part_name(const fs::path& file, int number) {
  constexpr std::size_t longest = 200;
  std::string name = file.filename().string().substr(0, longest);
  name.append(".").append(std::to_string(process_id()));
  if (number > 0) name.append("-").append(std::to_string(number));
  return file.parent_path() / name.append(part_ending);
}

/// Opens a new file for a part, whatever file is left there. Returns its descriptor, or -1.
int open_new(const fs::path& file, fs::path& part) {
  constexpr int most_tries = 1000;
  int descriptor = -1;
  for (int number = 0; number < most_tries; ++number) {
    part = part_name(file, number);
    descriptor = output_calls::open_new(part);
    if (descriptor >= 0 || errno != EEXIST) break;
  }
  return descriptor;
}

/// Writes all of it; returns 0, or the number of the error.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const std::ptrdiff_t count = output_calls::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// Says that the disk is full, and how much is missing where this is known.
Error disk_is_full(const fs::path& file, std::uint64_t missing) {
  std::error_code error;
  const fs::path folder = file.parent_path();
  const fs::space_info disk = fs::space(folder.empty() ? "." : folder, error);
  const std::uint64_t free = error ? 0 : disk.available;
  const std::string need =
      missing == 0 ? "" : ": " + size_text(missing) + " more are needed, and " + size_text(free) + " are free";
  return cannot_write(file, "the disk is full" + need + "; make room, or name a file on another disk");
}

/// Returns the process that writes a part: 1234 for "1234" and "1234-1".
std::optional<int> writer_of(std::string_view number) {
  int writer = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), writer);
  const std::string_view rest = number.substr(static_cast<std::size_t>(end - number.data()));
  const bool is_number = error == std::errc() && writer > 0 && (rest.empty() || rest.front() == '-');
  return is_number ? std::optional(writer) : std::nullopt;
}

}  // namespace

OutputFile::OutputFile(fs::path file, Unfinished unfinished, std::uint64_t expected)
    : file_(std::move(file)), unfinished_(unfinished), expected_(expected) {}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : file_(std::move(other.file_)),
      part_(std::move(other.part_)),
      pending_(std::move(other.pending_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      unfinished_(other.unfinished_),
      expected_(other.expected_),
      written_(other.written_),
      state_(std::move(other.state_)) {}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  if (unfinished_ == Unfinished::kept) static_cast<void>(flush());
  output_calls::close(descriptor_);
  std::error_code error;
  if (part_.empty() || (unfinished_ == Unfinished::kept && fs::file_size(part_, error) > 0)) return;
  fs::remove(part_, error);
}

Result<OutputFile> OutputFile::create(const fs::path& file, Unfinished unfinished, std::uint64_t expected) {
  std::error_code error;
  if (fs::is_directory(file, error)) return cannot_write(file, "it is a folder");
  const bool straight = is_device_or_pipe(file);
  OutputFile output(straight ? file : followed(file), unfinished, expected);
  if (const Status opened = straight ? output.open_straight() : output.open_part(); !opened) {
    return opened.error();
  }
  return output;
}

Status OutputFile::open_straight() {
  descriptor_ = output_calls::open_straight(file_);
  if (descriptor_ < 0 && errno == ENXIO) return cannot_write(file_, "it has no reader");
  if (descriptor_ < 0) return cannot_write(file_, errno);
  return Done{};
}

Status OutputFile::open_part() {
  descriptor_ = open_new(file_, part_);
  if (descriptor_ < 0) return cannot_write(file_, errno);
  std::error_code error;
  if (!fs::exists(file_, error)) return Done{};
  if (!may_write(file_)) return cannot_write(file_, errno);
  output_calls::take_rights(descriptor_, file_);
  return Done{};
}

Status OutputFile::fail(int error_number) {
  const std::uint64_t missing = std::max<std::uint64_t>(expected_, written_ + pending_.size()) - written_;
  const std::span<const int> full = output_calls::errors_of_a_full_disk();
  const bool is_full = std::ranges::find(full, error_number) != full.end();
  state_ = is_full && !part_.empty() ? disk_is_full(file_, missing) : cannot_write(file_, error_number);
  return state_;
}

std::optional<Error> OutputFile::full_disk_in(std::string_view words) const {
  const auto is_said = [&](int number) {
    return words.find(std::generic_category().message(number)) != std::string_view::npos;
  };
  if (!std::ranges::any_of(output_calls::errors_of_a_full_disk(), is_said)) return {};
  return disk_is_full(file_, 0);
}

Status OutputFile::flush() {
  if (!state_) return state_;
  if (const int error = write_all(descriptor_, pending_); error != 0) return fail(error);
  written_ += pending_.size();
  pending_.clear();
  return Done{};
}

Status OutputFile::write(std::string_view contents) {
  if (!state_) return state_;
  pending_ += contents;
  return pending_.size() < most_pending ? state_ : flush();
}

Status OutputFile::commit(Sync sync) {
  if (Status flushed = flush(); !flushed) return flushed;
  const bool is_part = !part_.empty();
  if (is_part && sync == Sync::disk && output_calls::sync(descriptor_) != 0 && errno != EINVAL) return fail(errno);
  const bool closed = output_calls::close(std::exchange(descriptor_, -1)) == 0;
  if (closed && (!is_part || output_calls::replace(part_, file_) == 0)) return Done{};
  const int error = errno;
  std::error_code ignored;
  if (is_part && unfinished_ == Unfinished::removed) fs::remove(part_, ignored);
  return fail(error);
}

bool is_device_or_pipe(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Status write_whole_file(const fs::path& file, std::string_view contents, OutputFile::Sync sync) {
  auto output = OutputFile::create(file, OutputFile::Unfinished::removed, contents.size());
  if (!output) return output.error();
  if (Status written = output->write(contents); !written) return written;
  return output->commit(sync);
}

Status write_output(const std::string& file, std::string_view contents) {
  return file == "-" ? print(contents) : write_whole_file(file, contents);
}

Status print(std::string_view text) {
  if (const int error = write_all(standard_output, text); error != 0) return cannot_write("standard output", error);
  return Done{};
}

Status check_can_be_written(std::string_view option, const fs::path& file) {
  if (is_device_or_pipe(file)) {  // to open a pipe and close it would tell its reader that all is over
    if (may_write(file)) return Done{};
    return Error{std::string(option) + " " + cannot_write(file, errno).message};
  }
  const auto output = OutputFile::create(file);
  return output ? Status(Done{}) : Error{std::string(option) + " " + output.error().message};
}

std::vector<fs::path> parts_left_beside(const fs::path& file) {
  const fs::path place = followed(file);
  const fs::path folder = place.parent_path();
  const std::string beginning = place.filename().string() + ".";
  std::vector<fs::path> parts;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(beginning) || !name.ends_with(part_ending)) continue;
    if (name.size() <= beginning.size() + part_ending.size()) continue;
    const auto writer =
        writer_of(std::string_view(name).substr(beginning.size(), name.size() - beginning.size() - part_ending.size()));
    if (writer && is_gone(*writer)) parts.push_back(folder / name);
  }
  return parts;
}

}  // namespace throng
