#pragma once

#include <utility>

#include <glad/gl.h>

namespace throng::render::gl {

/// Owns one OpenGL name, or none: 0.
template <typename Deleter>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ != 0) Deleter{}(id_);
  }

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

struct DeleteBuffer {
  void operator()(GLuint id) const { glDeleteBuffers(1, &id); }
};
struct DeleteTexture {
  void operator()(GLuint id) const { glDeleteTextures(1, &id); }
};
struct DeleteVertexArray {
  void operator()(GLuint id) const { glDeleteVertexArrays(1, &id); }
};
struct DeleteFramebuffer {
  void operator()(GLuint id) const { glDeleteFramebuffers(1, &id); }
};
struct DeleteRenderbuffer {
  void operator()(GLuint id) const { glDeleteRenderbuffers(1, &id); }
};
struct DeleteShader {
  void operator()(GLuint id) const { glDeleteShader(id); }
};
struct DeleteProgram {
  void operator()(GLuint id) const { glDeleteProgram(id); }
};

using Buffer = Handle<DeleteBuffer>;
using Texture = Handle<DeleteTexture>;
using VertexArray = Handle<DeleteVertexArray>;
using Framebuffer = Handle<DeleteFramebuffer>;
using Renderbuffer = Handle<DeleteRenderbuffer>;
using Shader = Handle<DeleteShader>;
using Program = Handle<DeleteProgram>;

inline Buffer create_buffer() {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  return Buffer(id);
}

/// Makes a buffer of fixed size and fills it once from `data`.
inline Buffer create_buffer(const void* data, std::size_t bytes) {
  Buffer buffer = create_buffer();
  // OpenGL refuses a size of zero, but a mesh without vertices is no error.
  glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(bytes == 0 ? 1 : bytes), bytes == 0 ? nullptr : data, 0);
  return buffer;
}

inline Texture create_texture(GLenum target) {
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  return Texture(id);
}

inline VertexArray create_vertex_array() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return VertexArray(id);
}

inline Framebuffer create_framebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return Framebuffer(id);
}

inline Renderbuffer create_renderbuffer() {
  GLuint id = 0;
  glCreateRenderbuffers(1, &id);
  return Renderbuffer(id);
}

}  // namespace throng::render::gl
