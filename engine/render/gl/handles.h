#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

#include <glad/gl.h>

namespace throng::render::gl {

/// Owns one OpenGL name, or none: 0.
template <void (*destroy)(GLuint)>
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
    if (id_ != 0) destroy(id_);
  }

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

inline void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void delete_texture(GLuint id) { glDeleteTextures(1, &id); }
inline void delete_sampler(GLuint id) { glDeleteSamplers(1, &id); }
inline void delete_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void delete_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void delete_renderbuffer(GLuint id) { glDeleteRenderbuffers(1, &id); }
inline void delete_shader(GLuint id) { glDeleteShader(id); }
inline void delete_program(GLuint id) { glDeleteProgram(id); }

using Buffer = Handle<delete_buffer>;
using Texture = Handle<delete_texture>;
using Sampler = Handle<delete_sampler>;
using VertexArray = Handle<delete_vertex_array>;
using Framebuffer = Handle<delete_framebuffer>;
using Renderbuffer = Handle<delete_renderbuffer>;
using Shader = Handle<delete_shader>;
using Program = Handle<delete_program>;

/// Makes one name with a function of OpenGL that makes many.
inline GLuint create_one(void (*create)(GLsizei, GLuint*)) {
  GLuint id = 0;
  create(1, &id);
  return id;
}

inline Buffer create_buffer() { return Buffer(create_one(glCreateBuffers)); }
inline Sampler create_sampler() { return Sampler(create_one(glCreateSamplers)); }
inline VertexArray create_vertex_array() { return VertexArray(create_one(glCreateVertexArrays)); }
inline Framebuffer create_framebuffer() { return Framebuffer(create_one(glCreateFramebuffers)); }
inline Renderbuffer create_renderbuffer() { return Renderbuffer(create_one(glCreateRenderbuffers)); }

/// Makes a buffer of fixed size. `data` may be null; without flags nothing else ever fills it.
inline Buffer create_buffer(const void* data, std::size_t bytes, GLbitfield flags = 0) {
  Buffer buffer = create_buffer();
  // OpenGL refuses a size of zero, but a mesh without vertices is no error.
  glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)),
                       bytes == 0 ? nullptr : data, flags);
  return buffer;
}

/// Takes elements to the device, again and again. It grows, never shrinks, and is never empty.
template <typename Element>
class GrowingBuffer {
 public:
  void upload(std::span<const Element> elements) {
    if (!buffer_ || elements.size() > capacity_) {
      capacity_ = std::bit_ceil(elements.size());
      buffer_ = create_buffer(nullptr, capacity_ * sizeof(Element), GL_DYNAMIC_STORAGE_BIT);
    }
    if (elements.empty()) return;
    glNamedBufferSubData(buffer_.id(), 0, static_cast<GLsizeiptr>(elements.size_bytes()), elements.data());
  }
  GLuint id() const { return buffer_.id(); }

 private:
  Buffer buffer_;
  std::size_t capacity_ = 0;  // elements
};

/// Makes a texture of two dimensions without pixels.
inline Texture create_texture(GLenum format, GLsizei width, GLsizei height, GLsizei mip_levels = 1) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  glTextureStorage2D(id, mip_levels, format, width, height);
  return Texture(id);
}

/// Makes a texture to draw into, without pixels, with as many samples a pixel as a target has: 0 or 4.
inline Texture create_target_texture(GLenum format, GLsizei width, GLsizei height, GLsizei samples) {
  if (samples == 0) return create_texture(format, width, height);
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &id);
  glTextureStorage2DMultisample(id, samples, format, width, height, GL_TRUE);
  return Texture(id);
}

/// Names the place in a vertex of an attribute that shaders read as floats. Integers become 0..1, signed ones -1..1.
struct FloatAttribute {
  GLint size;  ///< 1 to 4 numbers
  GLenum type;
  std::size_t offset;
};

/// Describes an attribute of the vertices of one binding.
inline void describe(const VertexArray& array, GLuint location, const FloatAttribute& attribute, GLuint binding = 0) {
  const auto& [size, type, offset] = attribute;
  glVertexArrayAttribFormat(array.id(), location, size, type, GL_TRUE, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(array.id(), location, binding);
  glEnableVertexArrayAttrib(array.id(), location);
}

/// Describes the vertices of `buffer`: the first attribute has location 0, the next 1, and so on.
inline VertexArray create_vertex_array(std::span<const FloatAttribute> attributes, const Buffer& buffer,
                                       GLsizei vertex_size) {
  VertexArray array = create_vertex_array();
  for (GLuint location = 0; location < attributes.size(); ++location) describe(array, location, attributes[location]);
  glVertexArrayVertexBuffer(array.id(), 0, buffer.id(), 0, vertex_size);
  return array;
}

}  // namespace throng::render::gl
