#include "engine/anim/import/model_files.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include "engine/anim/import/bytes/data_uri.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/source_file.h"

namespace throng::import {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_uri_length = 1024;
constexpr std::size_t max_shown_length = 120;

std::string in_quotes(std::string_view uri) {
  std::string quoted(1, '"');
  quoted += uri.substr(0, max_shown_length);
  if (uri.size() > max_shown_length) quoted += "...";
  return quoted + '"';
}

/// A way to read a uri as a file's name, and its oddity.
struct Reading {
  std::string name;
  std::string oddity;
};

bool has_stray_percent(std::string_view uri) {
  const auto is_hex = [&](std::size_t i) {
    return i < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i]));
  };
  for (std::size_t i = uri.find('%'); i != std::string_view::npos; i = uri.find('%', i + 1)) {
    if (!is_hex(i + 1) || !is_hex(i + 2)) return true;
  }
  return false;
}

/// Returns the readings of a uri, the reading of RFC 3986 first.
std::vector<Reading> readings_of(std::string_view uri) {
  std::vector<Reading> readings;
  const auto add = [&](std::string name, const char* oddity) {
    if (std::ranges::find(readings, name, &Reading::name) == readings.end()) {
      readings.push_back({std::move(name), oddity});
    }
  };
  add(decode_percent(uri), has_stray_percent(uri) ? "has a percent sign that is no escape" : "");
  add(std::string(uri), "has percent signs that are no escapes");
  const std::string_view path = uri.substr(0, uri.find_first_of("?#"));
  if (!path.empty()) add(decode_percent(path), "has a query or fragment, left out");
  for (std::size_t i = 0, count = readings.size(); i < count; ++i) {
    std::string name = readings[i].name;
    std::ranges::replace(name, '\\', '/');
    add(std::move(name), "has backslashes, taken as slashes");
  }
  return readings;
}

/// "C:" and "file:" are schemes, and "left arm:2.png" has none (RFC 3986, 3.1).
bool has_scheme(std::string_view uri) {
  const std::string_view scheme = uri.substr(0, uri.find(':'));
  if (scheme.size() == uri.size() || scheme.empty() || std::isalpha(static_cast<unsigned char>(scheme[0])) == 0) {
    return false;
  }
  return std::ranges::all_of(scheme,
                             [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '.' || c == '-'; });
}

/// Refuses names that lead out of a folder, even where a file is there.
void check_name(const std::string& name, const std::string& shown) {
  if (name.find('\0') != std::string::npos) throw Refusal("its uri holds a zero byte; rename the file");
  if (equal_without_case(name.substr(0, 4), "http")) {
    if (name.find("://") != std::string::npos) {
      throw Refusal("its uri " + shown + " is a web address; download that file beside the model and name it there");
    }
  }
  if (name.empty() || name.front() == '/' || has_scheme(name)) {
    throw Refusal("its uri " + shown + " is no relative path; put that file beside the model and name it there");
  }
  const fs::path path(name);
  if (std::ranges::find(path, "..") != path.end()) {
    throw Refusal("its uri " + shown + " leaves the model's folder; keep its files beside the model");
  }
}

void check_uri(std::string_view uri) {
  if (uri.empty()) throw Refusal("its uri is empty; name a file beside the model");
  if (uri.size() > max_uri_length) throw Refusal("its uri is longer than 1024 characters; rename the file");
}

bool is_below(const fs::path& folder, const fs::path& file) {
  const auto [in_folder, in_file] = std::ranges::mismatch(folder, file);
  return in_folder == folder.end() && in_file != file.end();
}

bool leaves(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) return true;
  const fs::path target = fs::canonical(file, error);
  return error || !is_below(root, target);
}

/// Returns the only entry of a folder that has this name but for the case of letters.
std::optional<fs::path> entry_without_case(const fs::path& folder, const std::string& name) {
  std::optional<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (!equal_without_case(entry->path().filename().string(), name)) continue;
    if (found) return std::nullopt;
    found = entry->path();
  }
  return found;
}

std::optional<fs::path> find_without_case(const fs::path& folder, const std::string& name) {
  fs::path path = folder;
  for (const fs::path& part : fs::path(name)) {
    std::error_code error;
    if (fs::exists(path / part, error)) {
      path /= part;
      continue;
    }
    const auto entry = entry_without_case(path, part.string());
    if (!entry) return std::nullopt;
    path = *entry;
  }
  return path;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

struct Found {
  fs::path folder;
  fs::path file;
  std::string oddity;
};

/// Finds the file that a uri names by one of its readings.
std::optional<Found> find_by_reading(const std::vector<fs::path>& folders, const std::vector<Reading>& readings) {
  for (const Reading& reading : readings) {
    for (const fs::path& folder : folders) {
      const fs::path file = folder / reading.name;
      if (is_file(file)) return Found{folder, file, reading.oddity};
    }
  }
  for (const Reading& reading : readings) {
    for (const fs::path& folder : folders) {
      const auto file = find_without_case(folder, reading.name);
      if (!file || !is_file(*file)) continue;
      return Found{
          folder, *file,
          "is found as " + in_quotes(file->lexically_relative(folder).string()) + ", whose letters have another case"};
    }
  }
  return std::nullopt;
}

/// Finds the file in memory that a uri names by one of its readings.
std::optional<Found> find_in_memory(std::span<const FileInMemory> files, const std::vector<Reading>& readings) {
  for (const Reading& reading : readings) {
    const std::string name = fs::path(reading.name).lexically_normal().generic_string();
    const auto found = std::ranges::find(files, name, &FileInMemory::name);
    if (found != files.end()) return Found{{}, std::string(found->name), reading.oddity};
  }
  return std::nullopt;
}

/// Names the thing in the place of the file.
[[noreturn]] void refuse_missing(const std::vector<fs::path>& folders, const std::string& name) {
  for (const fs::path& folder : folders) {
    std::error_code error;
    const fs::file_status status = fs::status(folder / name, error);
    if (fs::is_directory(status)) throw Refusal("its uri " + in_quotes(name) + " names a folder; name a file");
    if (fs::exists(status)) throw Refusal("its uri " + in_quotes(name) + " names no regular file; copy the file there");
    if (fs::is_symlink(fs::symlink_status(folder / name, error))) {
      throw Refusal("its file " + in_quotes(name) + " is a link that leads nowhere; copy the file there");
    }
  }
  throw Refusal("there is no file " + in_quotes(name) + " beside the model; copy it there");
}

}  // namespace

ModelFiles::ModelFiles(const ModelSource& source) : files_(source.files), strict_(source.strict) {
  if (!files_.empty()) return;
  const fs::path folder = source.path.parent_path();
  folders_.push_back(folder.empty() ? fs::path(".") : folder);
  std::error_code error;
  if (strict_ || !fs::is_symlink(fs::symlink_status(source.path, error))) return;
  const fs::path target = fs::canonical(source.path, error);
  if (!error) folders_.push_back(target.parent_path());
}

fs::path ModelFiles::find(std::string_view uri, const std::string& object, std::vector<std::string>& repairs) const {
  if (is_data_uri(uri)) return {};
  check_uri(uri);
  std::vector<Reading> readings = readings_of(uri);
  for (const Reading& reading : readings) check_name(reading.name, in_quotes(uri));
  const auto found = files_.empty() ? find_by_reading(folders_, readings) : find_in_memory(files_, readings);
  if (!found && !files_.empty()) {
    throw Refusal("no file in memory is named " + in_quotes(readings.front().name) + "; give it with the model");
  }
  if (!found) refuse_missing(folders_, readings.front().name);
  if (strict_ && files_.empty() && leaves(found->folder, found->file)) {
    throw Refusal("its uri " + in_quotes(uri) + " leaves the model's folder by a link; copy the file there");
  }
  if (!found->oddity.empty()) repairs.push_back(object + ": its uri " + in_quotes(uri) + " " + found->oddity);
  if (!files_.empty()) return found->file;
  std::error_code error;
  const fs::path file = fs::canonical(found->file, error);
  return error ? found->file : file;
}

std::vector<std::byte> ModelFiles::read(std::string_view uri, const fs::path& file, const std::string& object,
                                        MemoryAccount& memory) {
  if (file.empty()) {
    memory.charge(uri.size() * 2, object);
    std::vector<std::byte> bytes = decode_data_uri(uri);
    memory.release(uri.size() * 2 - bytes.size());
    return bytes;
  }
  const auto given = std::ranges::find(files_, file.generic_string(), &FileInMemory::name);
  const bool is_given = given != files_.end();
  std::error_code error;
  const std::uintmax_t size = is_given ? given->bytes.size() : fs::file_size(file, error);
  if (!error && counted_.insert(file).second) {
    memory.add_file(size, object);
  } else if (!error) {
    memory.charge(size, object);
  }
  return is_given ? std::vector<std::byte>(given->bytes.begin(), given->bytes.end()) : read_file(file);
}

}  // namespace throng::import
