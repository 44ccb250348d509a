#pragma once

#include "engine/render/frame/picture_tiles.h"
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
///   overlay.draw(*ImGui::GetDrawData(), all_pixels);
class OverlayRenderer {
 public:
  /// An ImGui context must be current. `shaders` must outlive the overlay.
  explicit OverlayRenderer(ShaderLibrary& shaders);

  /// Builds the font atlas of the current ImGui context and copies it to the device. Errors: the device takes no
  /// texture that large.
  Status upload_fonts();

  /// Draws the part of the data that is in the pixels `drawn` of the picture, over all of the bound framebuffer, and
  /// changes no pixel of it outside of `clip`. Leaves blending and scissoring off, and no program or vertex array
  /// bound.
  void draw(const ImDrawData& data, const PixelRect& drawn, const PixelRect& clip) const;
  void draw(const ImDrawData& data, const PixelRect& drawn) const { draw(data, drawn, {{0, 0}, drawn.size}); }

 private:
  void set_up(const ImDrawData& data, int picture_height, const PixelRect& drawn) const;

  const gl::Program& program_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
  gl::VertexArray vertex_array_;
  gl::Texture fonts_;
};

}  // namespace throng::render
