#include "engine/render/shader/shader_library.h"

#include <algorithm>
#include <system_error>

#include "engine/render/shader/shader_source.h"

namespace throng::render {
namespace {

/// Reads the log of a shader or a program with the functions for either.
std::string read_log(GLuint id, auto get_number, auto get_log) {
  GLint length = 0;
  get_number(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  get_log(id, length, nullptr, log.data());
  return length > 1 ? log : "the driver gives no reason";  // the length counts the 0 behind the log
}

void declare_captured(GLuint program, const std::vector<std::string>& captured) {
  std::vector<const char*> names;
  names.reserve(captured.size());
  for (const std::string& name : captured) names.push_back(name.c_str());
  if (names.empty()) return;
  glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(), GL_INTERLEAVED_ATTRIBS);
}

}  // namespace

ShaderLibrary::ShaderLibrary(std::filesystem::path folder) : folder_(std::move(folder)), built_from_(state_on_disk()) {}

ShaderLibrary::FolderState ShaderLibrary::state_on_disk() const {
  FolderState state{std::filesystem::file_time_type::min(), 0};
  std::error_code failed;  // a file that has just gone counts as old
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder_, failed)) {
    state.first = std::max(state.first, file.last_write_time(failed));
    ++state.second;
  }
  return state;
}

const gl::Program& ShaderLibrary::load(const ProgramFiles& files) {
  Result<gl::Program> program = build(files);
  if (!program && status_) status_ = program.error();
  programs_.push_back({files, program ? std::move(*program) : gl::Program()});
  return programs_.back().program;
}

Status ShaderLibrary::reload() {
  built_from_ = state_on_disk();  // before they are read, so that a file saved meanwhile is newer
  Status status = Done{};
  for (Entry& entry : programs_) {
    Result<gl::Program> program = build(entry.files);
    if (program) {
      entry.program = std::move(*program);
    } else if (status) {
      status = program.error();
    }
  }
  return status;
}

Result<gl::Program> ShaderLibrary::build(const ProgramFiles& files) const {
  const Result<gl::Shader> vertex = compile(GL_VERTEX_SHADER, files.vertex, files.switches);
  if (!vertex) return vertex.error();
  gl::Program program(glCreateProgram());
  glAttachShader(program.id(), vertex->id());
  const std::pair<GLenum, const std::string&> others[] = {{GL_GEOMETRY_SHADER, files.geometry},
                                                          {GL_FRAGMENT_SHADER, files.fragment}};
  for (const auto& [stage, file] : others) {
    if (file.empty()) continue;
    const Result<gl::Shader> shader = compile(stage, file, files.switches);
    if (!shader) return shader.error();
    glAttachShader(program.id(), shader->id());
  }
  declare_captured(program.id(), files.captured);
  glLinkProgram(program.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    const std::string log = read_log(program.id(), glGetProgramiv, glGetProgramInfoLog);
    return Error{"shaders " + files.vertex + " and " + files.fragment +
                 " do not link: " + log.substr(0, log.find('\n'))};
  }
  return program;
}

Result<gl::Shader> ShaderLibrary::compile(GLenum stage, const std::string& file,
                                          const std::vector<std::string>& switches) const {
  const Result<ShaderSource> source = read_shader_source(folder_, file, switches);
  if (!source) return source.error();
  gl::Shader shader(glCreateShader(stage));
  const char* text = source->text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    return Error{"shader does not compile: " +
                 first_complaint(read_log(shader.id(), glGetShaderiv, glGetShaderInfoLog), *source)};
  }
  return shader;
}

}  // namespace throng::render
