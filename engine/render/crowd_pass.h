#pragma once

#include <span>

#include "engine/render/crowd_draw.h"
#include "engine/render/indirect_draws.h"
#include "engine/render/mesh.h"
#include "engine/render/palette_buffer.h"
#include "engine/render/shader_library.h"

namespace throng::render {

/// Draws all agents: one call a page and material of a character, however many they are. Instances of one page must
/// follow each other, in the order of their batches, which name `meshes` by `character`. Frame uniforms and instances
/// must be bound (frame_uniforms.h).
class CrowdPass {
 public:
  static Result<CrowdPass> create(ShaderLibrary& shaders);

  /// Lit surfaces, or with `bones_as_lines` the bones alone.
  DrawCounts draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);

  /// The same agents thrown flat onto the ground along the sun's rays, each ground pixel darkened once. Wants the
  /// ground drawn, and a stencil of zeros, which it uses up.
  DrawCounts draw_shadows(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);

 private:
  explicit CrowdPass(const ShaderLibrary& shaders) : shaders_(&shaders) {}

  DrawCounts draw_surfaces(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);
  DrawCounts draw_bones(const CrowdFrame& frame, std::span<const CrowdMesh> meshes,
                        const PaletteBuffer& palettes) const;
  void use_material(const CrowdMaterial& material) const;

  const ShaderLibrary* shaders_;
  ProgramHandle opaque_{};
  ProgramHandle cut_out_{};
  ProgramHandle bones_{};
  ProgramHandle shadow_{};
  IndirectDraws surfaces_;
  IndirectDraws outlines_;
};

}  // namespace throng::render
