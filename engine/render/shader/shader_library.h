#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <glad/gl.h>

#include "engine/base/result.h"
#include "engine/render/gl/handles.h"

namespace throng::render {

/// Names the files of one program, in the library's folder.
struct ProgramFiles {
  std::string vertex;
  std::string fragment;                    ///< empty: the program only captures vertices
  std::vector<std::string> captured = {};  ///< varyings that transform feedback captures, interleaved
  std::string geometry = {};               ///< empty: none
  std::vector<std::string> switches = {};  ///< macros that all stages have
};

/// Builds programs from a folder of GLSL files. A line `#include "name.glsl"` stands for that file of the same folder,
/// once a stage. Errors name file and line as they are on disk.
class ShaderLibrary {
 public:
  explicit ShaderLibrary(std::filesystem::path folder);

  /// Builds a program, which lives as long as the library. If it cannot be built it has no name, and status() says why.
  /// A reload changes its name.
  const gl::Program& load(const ProgramFiles& files);

  /// Gives the first error of load().
  const Status& status() const { return status_; }

  /// Builds every program again from disk, and returns the first error. A program that fails keeps its last good build.
  Status reload();
  /// Returns whether a file of the folder was saved, added or removed since the programs were built last. It reads the
  /// folder, so a few calls a second are enough.
  bool is_out_of_date() const { return state_on_disk() != built_from_; }

 private:
  struct Entry {
    ProgramFiles files;
    gl::Program program;
  };

  /// The newest of the files, and how many there are.
  using FolderState = std::pair<std::filesystem::file_time_type, std::size_t>;

  FolderState state_on_disk() const;
  Result<gl::Program> build(const ProgramFiles& files) const;
  Result<gl::Shader> compile(GLenum stage, const std::string& file, const std::vector<std::string>& switches) const;

  std::filesystem::path folder_;
  FolderState built_from_;
  std::deque<Entry> programs_;  // they never move
  Status status_ = Done{};
};

}  // namespace throng::render
