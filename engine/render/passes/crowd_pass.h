#pragma once

#include <span>

#include "engine/render/crowd_draw.h"
#include "engine/render/mesh/mesh.h"
#include "engine/render/palette/palette_buffer.h"
#include "engine/render/passes/indirect_draws.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Draws all agents with one call for each page and material of a character, however many they are; materials that are
/// seen through take a second one.
/// Instances of one page must follow each other, in the order of their batches. A batch's `character` is an index into
/// `meshes`. Frame data must be bound.
class CrowdPass {
 public:
  explicit CrowdPass(ShaderLibrary& shaders);

  /// Draws lit surfaces or, with `bones_as_lines`, only the bones.
  DrawCounts draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);

  /// Says whether the last draw() left out parts that are seen through.
  bool has_blended() const { return !blended_.groups().empty(); }

  /// Adds those parts to the sums of a BlendPass.
  DrawCounts draw_blended(std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);

  /// Projects the same agents onto the ground along the sun's rays and darkens each ground pixel once. The ground must
  /// be drawn and the stencil all zeros; afterwards it is not. Nothing casts a shadow where it is cut out or seen
  /// through.
  DrawCounts draw_shadows(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);

 private:
  DrawCounts draw_surfaces(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);
  DrawCounts draw_bones(const CrowdFrame& frame, std::span<const CrowdMesh> meshes,
                        const PaletteBuffer& palettes) const;
  void use_material(const CrowdMaterial& material) const;
  void use_shadow_of(const CrowdMesh& mesh, int material) const;

  const gl::Program& opaque_;
  const gl::Program& glowing_;
  const gl::Program& cut_out_;
  const gl::Program& blended_part_;
  const gl::Program& bones_;
  const gl::Program& shadow_;
  const gl::Program& cut_out_shadow_;
  IndirectDraws surfaces_;
  IndirectDraws blended_;
  IndirectDraws outlines_;
};

}  // namespace throng::render
