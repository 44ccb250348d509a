#include "engine/render/passes/overlay_renderer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>
#include <imgui.h>

#include "engine/render/gl/device_errors.h"
#include "engine/render/passes/imgui_versions.h"

namespace throng::render {
namespace {

constexpr GLint to_clip_location = 0;

constexpr gl::FloatAttribute overlay_attributes[] = {{2, GL_FLOAT, offsetof(ImDrawVert, pos)},
                                                     {2, GL_FLOAT, offsetof(ImDrawVert, uv)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(ImDrawVert, col)}};

GLuint texture_of(const ImDrawCmd& command) { return static_cast<GLuint>(imgui::texture_name(command.GetTexID())); }

template <typename Element>
void upload(const gl::Buffer& buffer, const ImVector<Element>& elements) {
  glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(elements.size_in_bytes()), elements.Data, GL_STREAM_DRAW);
}

/// Gives a clip rectangle in pixels of the framebuffer.
PixelRect scissor_of(const ImDrawCmd& command, const ImDrawData& data, glm::ivec2 picture, const PixelRect& drawn,
                     const PixelRect& clip) {
  const auto pixel = [&](float x, float y) {
    const glm::vec2 scale(data.FramebufferScale.x, data.FramebufferScale.y);
    const glm::vec2 point = (glm::vec2(x, y) - glm::vec2(data.DisplayPos.x, data.DisplayPos.y)) * scale;
    const glm::ivec2 from_top = glm::clamp(glm::ivec2(point), glm::ivec2(0), picture);
    return glm::clamp(glm::ivec2(from_top.x, picture.y - from_top.y) - drawn.corner, clip.corner,
                      clip.corner + clip.size);
  };
  const glm::ivec2 top_left = pixel(command.ClipRect.x, command.ClipRect.y);
  const glm::ivec2 bottom_right = pixel(command.ClipRect.z, command.ClipRect.w);
  return {{top_left.x, bottom_right.y}, {bottom_right.x - top_left.x, top_left.y - bottom_right.y}};
}

void draw_command(const ImDrawCmd& command, const PixelRect& scissor) {
  if (scissor.size.x <= 0 || scissor.size.y <= 0 || command.ElemCount == 0) return;
  glScissor(scissor.corner.x, scissor.corner.y, scissor.size.x, scissor.size.y);
  glBindTextureUnit(0, texture_of(command));
  constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  const std::uintptr_t first_byte = command.IdxOffset * sizeof(ImDrawIdx);
  glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type,
                           reinterpret_cast<const void*>(first_byte), static_cast<GLint>(command.VtxOffset));
}

glm::ivec2 picture_size(const ImDrawData& data) {
  return {static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x),
          static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y)};
}

}  // namespace

OverlayRenderer::OverlayRenderer(ShaderLibrary& shaders)
    : program_(shaders.load({"overlay.vert", "overlay.frag"})),
      vertices_(gl::create_buffer()),
      indices_(gl::create_buffer()),
      vertex_array_(gl::create_vertex_array(overlay_attributes, vertices_, sizeof(ImDrawVert))) {
  glVertexArrayElementBuffer(vertex_array_.id(), indices_.id());
  ImGuiIO& io = ImGui::GetIO();
  io.BackendRendererName = "throng";
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
}

Status OverlayRenderer::upload_fonts() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  fonts_ = gl::create_texture(GL_RGBA8, width, height);
  glTextureSubImage2D(fonts_.id(), 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  glTextureParameteri(fonts_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(fonts_.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  atlas.SetTexID(imgui::texture_id(fonts_.id()));
  return gl::take_errors("the letters of the overlay; ask for a smaller --ui-scale");
}

void OverlayRenderer::set_up(const ImDrawData& data, int picture_height, const PixelRect& drawn) const {
  glViewport(0, 0, drawn.size.x, drawn.size.y);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_.id());
  glBindVertexArray(vertex_array_.id());
  // Maps points to clip space by a scale of x and y and an offset of both; ImGui's y points down.
  const float scale_x = 2.0F * data.FramebufferScale.x / static_cast<float>(drawn.size.x);
  const float scale_y = -2.0F * data.FramebufferScale.y / static_cast<float>(drawn.size.y);
  const float left = -2.0F * static_cast<float>(drawn.corner.x) / static_cast<float>(drawn.size.x) - 1.0F;
  const float top =
      2.0F * static_cast<float>(picture_height - drawn.corner.y) / static_cast<float>(drawn.size.y) - 1.0F;
  glUniform4f(to_clip_location, scale_x, scale_y, left - data.DisplayPos.x * scale_x,
              top - data.DisplayPos.y * scale_y);
}

void OverlayRenderer::draw(const ImDrawData& data, const PixelRect& drawn, const PixelRect& clip) const {
  const glm::ivec2 picture = picture_size(data);
  if (picture.x <= 0 || picture.y <= 0) return;
  set_up(data, picture.y, drawn);
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    upload(vertices_, list.VtxBuffer);
    upload(indices_, list.IdxBuffer);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr) {
        command.UserCallback(&list, &command);
      } else {
        draw_command(command, scissor_of(command, data, picture, drawn, clip));
      }
    }
  }
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glBindVertexArray(0);
  glUseProgram(0);
}

}  // namespace throng::render
