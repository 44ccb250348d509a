#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "throng/render/crowd_draw.h"

#include "engine/render/mesh/mesh.h"
#include "engine/render/palette/palette_buffer.h"
#include "engine/render/passes/indirect_draws.h"
#include "engine/render/shader/program_variants.h"

namespace throng::render {

/// Draws all agents with one call for each page and material of a character, however many they are; materials that are
/// seen through take a second one.
/// Instances of one page must follow each other, in the order of their batches. A batch's `character` is an index into
/// `meshes`. Frame data must be bound.
class CrowdPass {
 public:
  /// `shaders` must outlive the pass. `calls` says how opaque surfaces are drawn.
  CrowdPass(ShaderLibrary& shaders, Calls calls);

  /// Makes ready for meshes that morph. Without it, all are drawn as they rest. The status of the shaders says whether
  /// it went well.
  void prepare_morphs();

  /// Draws lit surfaces.
  DrawCounts draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);

  /// Says whether the last draw() left out parts that are seen through.
  bool has_blended() const { return !blended_.groups().empty(); }

  /// Adds those parts to the sums of a BlendPass.
  DrawCounts draw_blended(std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);

  /// Sets the state that all draws of a frame share. Call it before them.
  /// `light` has the parts that the frame's light has (light_parts.h).
  void begin(const CrowdFrame& frame, std::uint32_t light);

 private:
  /// The programs that draw surfaces; all have the same uniforms.
  struct Programs {
    /// `always` are switches that all of them have.
    Programs(ShaderLibrary& shaders, const std::vector<std::string>& always);

    ProgramVariants plain;
    ProgramVariants material;
    ProgramVariants cut_out;
    ProgramVariants blended_part;
  };

  /// Returns the programs for a mesh; programs that morph cost more.
  Programs& programs_for(const CrowdMesh& mesh) { return morphs_ && mesh.has_morphs() ? *morphed_ : plain_; }
  void use_material(const CrowdMesh& mesh, const IndirectDraws::Group& group);

  ShaderLibrary* shaders_;
  Programs plain_;
  std::optional<Programs> morphed_;
  bool morphs_ = false;         // an instance of the frame has weights
  std::uint32_t switches_ = 0;  // of the light, and whether a colour stands for a value of an instance or a vertex
  IndirectDraws surfaces_;
  IndirectDraws blended_;
};

}  // namespace throng::render
