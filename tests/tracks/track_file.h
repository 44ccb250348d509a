#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/tracks/read.h"
#include "tests/own_folder.h"

namespace throng {

/// A folder with the files that a test reads.
class TrackFolder {
 public:
  /// Writes a file and returns its path.
  std::string file(std::string_view name, std::string_view contents) const {
    const std::string path = this->path(name);
    std::ofstream(path, std::ios::binary).write(contents.data(), static_cast<std::streamsize>(contents.size()));
    return path;
  }
  std::string path(std::string_view name) const { return (folder_.path() / name).string(); }

 private:
  throng::test::OwnFolder folder_;
};

/// Reads a text as a file; what is said of it.
inline Result<Trajectories> read_as(std::string_view name, std::string_view contents,
                                    const TrackReading& options = {}) {
  const TrackFolder folder;
  return read_trajectories(folder.file(name, contents), options);
}

/// Returns the error without the folder; empty if the text is read.
inline std::string error_of(std::string_view name, std::string_view contents, const TrackReading& options = {}) {
  const auto read = read_as(name, contents, options);
  if (read) return {};
  const std::string& message = read.error().message;
  return message.substr(message.find(name));
}

/// Returns the place of a row in the file's axes.
inline glm::dvec2 file_place(const Trajectories& tracks, const TrackRow& row) {
  return {tracks.origin.x + static_cast<double>(row.x), tracks.origin.y - static_cast<double>(row.z)};
}

/// Returns all that was told apart, as one text.
inline std::string all_said(const Trajectories& tracks) {
  std::string text;
  for (const std::string& remark : tracks.remarks) text += remark + "\n";
  return text;
}

/// Returns how often an oddity was found.
inline std::size_t found(const Trajectories& tracks, TrackOddity oddity) {
  for (const OddityCount& each : tracks.report.found) {
    if (each.oddity == oddity) return each.count;
  }
  return 0;
}

}  // namespace throng
