#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glad/gl.h>

#include "engine/render/gl/handles.h"
#include "engine/render/result.h"

namespace throng::render {

/// What one program is made of: file names in the library's folder.
struct ProgramFiles {
  std::string vertex;
  std::string fragment;               ///< empty: none, for programs whose vertices are captured
  std::vector<std::string> captured;  ///< varyings for transform feedback, interleaved
};

/// Names a program of a ShaderLibrary for as long as the library lives.
enum class ProgramHandle : std::size_t {};

/// Programs from a folder of GLSL files. A line `#include "name.glsl"` is replaced by that file of the same folder;
/// each file is taken once a stage. Errors name the file and line as written on disk.
class ShaderLibrary {
 public:
  explicit ShaderLibrary(std::filesystem::path folder);

  Result<ProgramHandle> load(const ProgramFiles& files);

  /// Valid until the next reload.
  GLuint id(ProgramHandle program) const { return programs_[static_cast<std::size_t>(program)].program.id(); }

  /// Builds every program again from disk. One that fails keeps its last good build; the first failure is returned.
  Status reload();

 private:
  struct Entry {
    ProgramFiles files;
    gl::Program program;
  };

  Result<gl::Program> build(const ProgramFiles& files) const;
  Result<gl::Shader> compile(GLenum stage, const std::string& file) const;

  std::filesystem::path folder_;
  std::vector<Entry> programs_;
};

}  // namespace throng::render
