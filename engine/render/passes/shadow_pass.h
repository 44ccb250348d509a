#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "throng/render/crowd_draw.h"

#include "engine/render/light/cascades.h"
#include "engine/render/light/shadow_uniforms.h"
#include "engine/render/mesh/mesh.h"
#include "engine/render/palette/palette_buffer.h"
#include "engine/render/passes/casters.h"
#include "engine/render/passes/indirect_draws.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Draws the view of the sun: a map of depths for each cascade, which shaders/shadows.glsl reads. Casters are drawn
/// with meshes that are coarser than the seen ones, as far as a texel hides it. Nothing casts a shadow where it is cut
/// out or seen through.
class ShadowPass {
 public:
  static constexpr int map_side = 2048;  ///< texels

  /// `shaders` must outlive the pass.
  explicit ShadowPass(ShaderLibrary& shaders);

  /// Makes ready for meshes that morph.
  void prepare_morphs();

  struct Light {
    glm::vec3 to_sun{0.0F, 1.0F, 0.0F};
    DepthRange depths = {};  ///< of the frame
    bool in_turns = false;   ///< the cascades far away are drawn in every second and fourth frame only
  };

  /// Draws the maps of the frame that was uploaded last. Its camera is the whole picture's.
  /// `draw_others(cascade)` draws the depths of casters beside the crowd, and returns its counts.
  DrawCounts draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                  const Light& light, const auto& draw_others) {
    DrawCounts counts = draw_crowd(frame, meshes, palettes, light);
    for (std::size_t i = 0; i < cascades_.size(); ++i) {
      if (!drawn_now_.at(i)) continue;
      glBindFramebuffer(GL_FRAMEBUFFER, targets_.at(i).id());
      add(counts, draw_others(cascades_.at(i)));
    }
    end();
    return counts;
  }

  /// Binds the maps and says in `uniforms` where they lie.
  void describe(const CrowdFrame& frame, ShadowUniforms& uniforms) const;

 private:
  struct Programs {
    Programs(ShaderLibrary& shaders, const std::vector<std::string>& switches);

    const gl::Program& opaque;
    const gl::Program& cut_out;
  };

  DrawCounts draw_crowd(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                        const Light& light);
  static void end();
  bool is_due(int cascade, bool in_turns) const;
  void plan(const CrowdFrame& frame, const Light& light);
  void gather(const CrowdFrame& frame, std::span<const CrowdMesh> meshes);
  struct CastersOfRun {
    std::size_t cascade;
    std::size_t first_batch;
  };
  void gather_run(std::span<const CrowdBatch> run, CastersOfRun of, const CrowdMesh& mesh, std::uint32_t& first_caster);
  void draw_cascade(int cascade, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);
  void use_program(const CrowdMesh& mesh, int material, int cascade) const;

  ShaderLibrary* shaders_;
  Programs plain_;
  std::optional<Programs> morphed_;
  bool morphs_ = false;  // an instance of the frame has weights
  gl::Texture maps_;     // without storage until the first draw
  std::array<gl::Framebuffer, cascade_count> targets_;
  DepthRange depths_{};
  SunAxes axes_{};
  std::array<Cascade, cascade_count> cascades_{};
  std::array<bool, cascade_count> drawn_now_{};
  std::array<std::uint32_t, cascade_count + 1> first_group_{};
  std::uint32_t turn_ = 0;
  Casters casters_;
  std::vector<float> reaches_;              // [character]
  std::vector<CrowdBatch> caster_batches_;  // of the run that is gathered
  gl::GrowingBuffer<std::uint32_t> caster_buffer_;
  IndirectDraws draws_;
};

}  // namespace throng::render
