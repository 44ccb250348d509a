#pragma once

#include <glm/vec2.hpp>

#include "engine/render/shader/shader_library.h"

struct ImDrawData;

namespace throng::render {

/// Draws ImGui's output onto the bound framebuffer, in every context (window, EGL, OSMesa). ImGui's colours are sRGB
/// and are blended unconverted, so the framebuffer must not convert.
///
///   ImGui::CreateContext(); fonts;
///   OverlayRenderer overlay(shaders);     // sets ImGui's renderer flags
///   overlay.upload_fonts();               // again after adding fonts
///   ImGui::NewFrame(); ... ImGui::Render();
///   overlay.draw(*ImGui::GetDrawData());
class OverlayRenderer {
 public:
  /// An ImGui context must be current. `shaders` must outlive the overlay.
  explicit OverlayRenderer(ShaderLibrary& shaders);

  /// Builds the font atlas of the current ImGui context and copies it to the device.
  void upload_fonts();

  /// Draws the data. Leaves blending and scissoring off, and no program or vertex array bound.
  void draw(const ImDrawData& data) const;

 private:
  void set_up(const ImDrawData& data, glm::ivec2 target) const;

  const gl::Program& program_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
  gl::VertexArray vertex_array_;
  gl::Texture fonts_;
};

}  // namespace throng::render
