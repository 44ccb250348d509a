#include "engine/render/shader/shader_library.h"

#include <utility>

#include "engine/render/shader/shader_source.h"

namespace throng::render {
namespace {

std::string link_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(program, length, nullptr, log.data());
  return log.substr(0, log.find('\n'));
}

std::string compile_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  return log;
}

void declare_captured(GLuint program, const std::vector<std::string>& captured) {
  std::vector<const char*> names;
  names.reserve(captured.size());
  for (const std::string& name : captured) names.push_back(name.c_str());
  if (names.empty()) return;
  glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(), GL_INTERLEAVED_ATTRIBS);
}

}  // namespace

ShaderLibrary::ShaderLibrary(std::filesystem::path folder) : folder_(std::move(folder)) {}

Result<ProgramHandle> ShaderLibrary::load(const ProgramFiles& files) {
  Result<gl::Program> program = build(files);
  if (!program) return program.error();
  programs_.push_back({files, std::move(*program)});
  return static_cast<ProgramHandle>(programs_.size() - 1);
}

Status ShaderLibrary::reload() {
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
  const Result<gl::Shader> vertex = compile(GL_VERTEX_SHADER, files.vertex);
  if (!vertex) return vertex.error();
  gl::Program program(glCreateProgram());
  glAttachShader(program.id(), vertex->id());
  Result<gl::Shader> fragment = gl::Shader();
  if (!files.fragment.empty()) {
    fragment = compile(GL_FRAGMENT_SHADER, files.fragment);
    if (!fragment) return fragment.error();
    glAttachShader(program.id(), fragment->id());
  }
  declare_captured(program.id(), files.captured);
  glLinkProgram(program.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    return Error{"shaders " + files.vertex + " and " + files.fragment + " do not link: " + link_log(program.id())};
  }
  return program;
}

Result<gl::Shader> ShaderLibrary::compile(GLenum stage, const std::string& file) const {
  const Result<ShaderSource> source = read_shader_source(folder_, file);
  if (!source) return source.error();
  gl::Shader shader(glCreateShader(stage));
  const char* text = source->text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    return Error{"shader does not compile: " + first_complaint(compile_log(shader.id()), *source)};
  }
  return shader;
}

}  // namespace throng::render
