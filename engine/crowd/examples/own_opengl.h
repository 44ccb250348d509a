#pragma once

// What any program without a window that draws with OpenGL 4.5 has: a context, shaders, buffers and a picture.
#define EGL_NO_PLATFORM_SPECIFIC_TYPES
#define GL_GLEXT_PROTOTYPES
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <png.h>

inline constexpr int width = 640, height = 360;

/// The shaders of own_opengl.cpp. An instance names its two palettes; the vertex shader blends what they show.
inline constexpr const char* vertex_shader = R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uvec4 entries;
layout(location = 3) in vec4 weights;
struct Instance {  // throng/render/instance_record.h
  float x, y, z, scale, cosine, sine;
  uint from, to, start, duration, agent, color, level, weights;
  float contact_scale;
};
layout(std430, binding = 0) readonly buffer Instances { Instance instances[]; };
layout(std430, binding = 1) readonly buffer Page { vec4 rows[]; };            // three a palette entry, four a line
layout(std430, binding = 2) readonly buffer Levels { uint entry_at_level[]; };  // [bone level][palette entry]
layout(location = 0) uniform mat4 clip_from_world;
layout(location = 1) uniform uvec3 first_now_entries;
out vec3 shade;
vec3 posed(uint line, uint level, vec4 v) {
  vec3 sum = vec3(0);
  for (int i = 0; i < 4; ++i) {
    uint row = line * 4 + 3 * entry_at_level[level * first_now_entries.z + entries[i]];
    sum += weights[i] * vec3(dot(rows[row], v), dot(rows[row + 1], v), dot(rows[row + 2], v));
  }
  return sum;
}
void main() {
  Instance one = instances[first_now_entries.x + gl_InstanceID];
  float shown = one.duration == 0 ? 1 : clamp(float(first_now_entries.y - one.start) / float(one.duration), 0, 1);
  vec3 p = one.scale * mix(posed(one.from, one.level, vec4(position, 1)), posed(one.to, one.level, vec4(position, 1)), shown);
  vec3 n = mix(posed(one.from, one.level, vec4(normal, 0)), posed(one.to, one.level, vec4(normal, 0)), shown);
  mat3 turn = mat3(one.cosine, 0, -one.sine, 0, 1, 0, one.sine, 0, one.cosine);
  gl_Position = clip_from_world * vec4(turn * p + vec3(one.x, one.y, one.z), 1);
  float hue = float(one.agent % 7) / 7;
  shade = (0.35 + 0.65 * max(dot(normalize(turn * n), vec3(0.4, 0.8, 0.45)), 0)) * mix(vec3(0.85, 0.42, 0.22), vec3(0.16, 0.36, 0.72), hue);
})";
inline constexpr const char* fragment_shader =
    "#version 450\nin vec3 shade; out vec4 color; void main() { color = vec4(pow(shade, vec3(0.4545)), 1); }";

inline bool open_context() {
  const auto display_of =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display = display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return false;
  const EGLContext context = eglCreateContext(display, nullptr, EGL_NO_CONTEXT, wanted);
  return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

inline GLuint program_of(const char* vertex, const char* fragment) {
  const GLuint program = glCreateProgram();
  for (const auto& [kind, source] : {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  return program;
}

template <typename Element>
GLuint buffer_of(std::span<const Element> data) {
  GLuint buffer = 0;
  glCreateBuffers(1, &buffer);
  glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(std::max<std::size_t>(data.size_bytes(), 1)), data.data(), 0);
  return buffer;
}

/// Binds a target and the program, for a picture of the sky's colour.
inline void begin_picture() {
  GLuint target = 0, images[2] = {};
  glCreateFramebuffers(1, &target);
  glCreateRenderbuffers(2, images);
  glNamedRenderbufferStorage(images[0], GL_RGBA8, width, height);
  glNamedRenderbufferStorage(images[1], GL_DEPTH_COMPONENT24, width, height);
  glNamedFramebufferRenderbuffer(target, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, images[0]);
  glNamedFramebufferRenderbuffer(target, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, images[1]);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glViewport(0, 0, width, height);
  glClearColor(0.86F, 0.87F, 0.88F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glUseProgram(program_of(vertex_shader, fragment_shader));
}

/// Reads the picture and writes it as a PNG.
inline bool write_picture(const char* file) {
  std::vector<unsigned char> pixels(std::size_t{4} * width * height);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = PNG_FORMAT_RGBA;
  return png_image_write_to_file(&image, file, 0, pixels.data(), -4 * width, nullptr) != 0;
}
