#pragma once

#include <glm/vec2.hpp>

#include "engine/render/gl/handles.h"
#include "engine/render/result.h"
#include "engine/render/shader_library.h"

struct ImDrawData;

namespace throng::render {

/// Draws ImGui's output in every context (window, EGL, OSMesa), onto the framebuffer that is bound. ImGui's colours are
/// sRGB and are blended as they are, so that framebuffer must not convert.
///
///   ImGui::CreateContext(); fonts;
///   auto overlay = OverlayRenderer::create(shaders);     // sets ImGui's renderer flags
///   overlay->upload_fonts();                             // again whenever fonts were added
///   ImGui::NewFrame(); ... ImGui::Render();
///   overlay->draw(*ImGui::GetDrawData());
class OverlayRenderer {
 public:
  /// An ImGui context must be current. `shaders` must outlive the overlay.
  static Result<OverlayRenderer> create(ShaderLibrary& shaders);

  /// Builds the font atlas of the current ImGui context and copies it to the device.
  void upload_fonts();

  /// Leaves blending and scissoring off and no program or vertex array bound.
  void draw(const ImDrawData& data) const;

 private:
  OverlayRenderer(const ShaderLibrary& shaders, ProgramHandle program);

  void set_up(const ImDrawData& data, glm::ivec2 target) const;

  const ShaderLibrary* shaders_;
  ProgramHandle program_;
  gl::VertexArray vertex_array_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
  gl::Texture fonts_;
};

}  // namespace throng::render
