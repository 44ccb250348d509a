#include "engine/render/passes/crowd_pass.h"

#include <algorithm>

#include "engine/render/frame/frame_data.h"
#include "engine/render/light/light_parts.h"
#include "engine/render/passes/crowd_surfaces.h"

namespace throng::render {
namespace {

/// Locations of uniforms of materials, after the locations that every program of the crowd has.
enum Location : GLint { emission_location = 3, unlit_location = 4, factors_location = 6 };

enum Unit : GLuint { base_color_unit, emission_unit, metallic_roughness_unit, normal_unit, occlusion_unit, unit_count };

// Switches of the crowd, after the light's; the last two are of crowd.frag alone.
constexpr std::uint32_t debug_colors_bit = 1U << light_part_count, textured_bit = 2U << light_part_count,
                        dressed_bit = 4U << light_part_count;

// Parts of blended surfaces with more alpha are drawn as cut-outs: hair and lashes then hide what is behind them.
constexpr float solid_alpha = 0.9F;

void bind_texture(Unit unit, const CrowdTexture& texture) {
  glBindTextureUnit(unit, texture.image);
  glBindSampler(unit, texture.sampler);
}

/// Sets the uniforms of a material for the program in use, which may ignore some.
void set_uniforms(const CrowdMaterial& material) {
  glUniform4fv(base_color_location, 1, material.base_color);
  bind_texture(base_color_unit, material.base_color_texture);
  if (material.coverage == Coverage::opaque && material.is_plain) return;
  glUniform3fv(emission_location, 1, material.emission);
  glUniform1i(unlit_location, material.unlit ? 1 : 0);
  bind_texture(emission_unit, material.emission_texture);
  glUniform4fv(factors_location, 1, material.factors);
  bind_texture(metallic_roughness_unit, material.metallic_roughness_texture);
  bind_texture(normal_unit, material.normal_texture);
  bind_texture(occlusion_unit, material.occlusion_texture);
}

/// Lets other passes read textures by the textures' own filters again.
void unbind_samplers() {
  for (GLuint unit = 0; unit < unit_count; ++unit) glBindSampler(unit, 0);
}

void test_depth() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace

CrowdPass::Programs::Programs(ShaderLibrary& shaders, const std::vector<std::string>& always)
    : plain(shaders, {.vertex = "crowd_plain.vert", .fragment = "crowd.frag", .switches = always},
            light_switches({"DEBUG_COLORS", "TEXTURED", "DRESSED"})),
      material(shaders, {.vertex = "crowd.vert", .fragment = "crowd_material.frag", .switches = always},
               light_switches({"DEBUG_COLORS"})),
      cut_out(shaders, {.vertex = "crowd.vert", .fragment = "crowd_cut_out.frag", .switches = always},
              light_switches({"DEBUG_COLORS"})),
      blended_part(shaders, {.vertex = "crowd.vert", .fragment = "crowd_blended.frag", .switches = always},
                   light_switches({"DEBUG_COLORS"})) {}

CrowdPass::CrowdPass(ShaderLibrary& shaders, Calls calls) : shaders_(&shaders), plain_(shaders, {}), surfaces_(calls) {}

void CrowdPass::prepare_morphs() {
  if (!morphed_) morphed_.emplace(*shaders_, std::vector<std::string>{"MORPHED"});
}

void CrowdPass::begin(const CrowdFrame& frame, std::uint32_t light) {
  constexpr std::uint32_t opacity = 0xFF000000U;
  morphs_ = morphed_.has_value() && !frame.morph_weights.empty();
  const bool has_debug_colors =
      frame.weighed.count > 0 || std::ranges::any_of(frame.instances, [](const InstanceRecord& record) {
        return (record.debug_color & opacity) != 0;
      });
  switches_ = light | (has_debug_colors ? debug_colors_bit : 0U);
}

DrawCounts CrowdPass::draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes) {
  test_depth();
  compose_surfaces(frame.batches, meshes, blended_, is_blended);
  compose_dressed_surfaces(frame, meshes, surfaces_);
  surfaces_.upload();
  for (const IndirectDraws::Group& group : surfaces_.groups()) {
    const CrowdMesh& mesh = meshes[group.character];
    use_material(mesh, group);
    mesh.bind();
    palettes.bind(group.page, palette_binding);
    surfaces_.draw(group);
  }
  glDisable(GL_CULL_FACE);
  unbind_samplers();
  return surfaces_.counts();
}

void CrowdPass::use_material(const CrowdMesh& mesh, const IndirectDraws::Group& group) {
  const CrowdMaterial& material = mesh.materials()[group.material];
  Programs& programs = programs_for(mesh);
  if (material.coverage == Coverage::opaque) {
    const std::uint32_t kind = material.is_textured ? textured_bit : group.is_dressed ? dressed_bit : 0U;
    glUseProgram((material.is_plain ? programs.plain.with(switches_ | kind) : programs.material.with(switches_)).id());
  } else {
    glUseProgram(programs.cut_out.with(switches_).id());
    glUniform1f(alpha_cutoff_location, is_blended(material) ? solid_alpha : material.alpha_cutoff);
  }
  set_uniforms(material);
  set_culling(material);
}

DrawCounts CrowdPass::draw_blended(std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes) {
  blended_.upload();
  for (const IndirectDraws::Group& group : blended_.groups()) {
    const CrowdMaterial& material = meshes[group.character].materials()[group.material];
    glUseProgram(programs_for(meshes[group.character]).blended_part.with(switches_).id());
    glUniform1f(alpha_cutoff_location, solid_alpha);
    set_uniforms(material);
    set_culling(material);
    meshes[group.character].bind();
    palettes.bind(group.page, palette_binding);
    blended_.draw(group);
  }
  unbind_samplers();
  return blended_.counts();
}

}  // namespace throng::render
