#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glad/gl.h>

#include "engine/render/gl/handles.h"
#include "engine/result.h"

namespace throng::render {

/// Names the files of one program, in the library's folder.
struct ProgramFiles {
  std::string vertex;
  std::string fragment;               ///< empty: the program only captures vertices
  std::vector<std::string> captured;  ///< varyings that transform feedback captures, interleaved
};

/// Names a program as long as its ShaderLibrary lives.
enum class ProgramHandle : std::size_t {};

/// Builds programs from a folder of GLSL files. A line `#include "name.glsl"` stands for that file of the same folder,
/// once a stage. Errors name file and line as they are on disk.
class ShaderLibrary {
 public:
  explicit ShaderLibrary(std::filesystem::path folder);

  Result<ProgramHandle> load(const ProgramFiles& files);

  /// Gives the OpenGL name, which is valid until the next reload.
  GLuint id(ProgramHandle program) const { return programs_[static_cast<std::size_t>(program)].program.id(); }

  /// Builds every program again from disk. One that fails keeps its last good build; the first error is returned.
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
