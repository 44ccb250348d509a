#include "engine/render/crowd_pass.h"

#include <algorithm>

#include "engine/render/frame_uniforms.h"

namespace throng::render {
namespace {

/// Uniform locations, the same in every program of the crowd; 0 is CrowdMesh::bind's.
enum Location : GLint { base_color_location = 1, alpha_cutoff_location = 2 };

/// Calls `do_page` with the batches of each page.
void for_each_page(std::span<const CrowdBatch> batches, const auto& do_page) {
  while (!batches.empty()) {
    const auto other =
        std::ranges::find_if(batches, [&](const CrowdBatch& batch) { return batch.page != batches[0].page; });
    const auto count = static_cast<std::size_t>(other - batches.begin());
    do_page(batches.first(count));
    batches = batches.subspan(count);
  }
}

void compose_surfaces(std::span<const CrowdBatch> batches, const CrowdMesh& mesh, IndirectDraws& draws) {
  draws.clear();
  for_each_page(batches, [&](std::span<const CrowdBatch> page) {
    for (std::size_t material = 0; material < mesh.material_count(); ++material) {
      draws.begin_group(page[0].page, static_cast<int>(material));
      for (const CrowdBatch& batch : page) {
        for (const MaterialRun& run : mesh.runs(batch.mesh_lod)) {
          if (run.material == static_cast<int>(material)) draws.add(run, batch);
        }
      }
    }
  });
}

void compose_outlines(std::span<const CrowdBatch> batches, const CrowdMesh& mesh, IndirectDraws& draws) {
  draws.clear();
  for_each_page(batches, [&](std::span<const CrowdBatch> page) {
    draws.begin_group(page[0].page, 0);
    for (const CrowdBatch& batch : page) {
      // An outline needs no more triangles than the next coarser mesh LOD has.
      const std::size_t lod = std::min<std::size_t>(batch.mesh_lod + 1UL, mesh.lod_count() - 1);
      for (const MaterialRun& run : mesh.runs(lod)) draws.add(run, batch);
    }
  });
}

void test_depth() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace

Result<CrowdPass> CrowdPass::create(ShaderLibrary& shaders) {
  CrowdPass pass(shaders);
  struct Wanted {
    ProgramHandle CrowdPass::*program;
    ProgramFiles files;
  };
  const Wanted wanted[] = {
      {&CrowdPass::opaque_, {"crowd.vert", "crowd.frag", {}}},
      {&CrowdPass::cut_out_, {"crowd.vert", "crowd_cut_out.frag", {}}},
      {&CrowdPass::bones_, {"crowd.vert", "bones.frag", {}}},
      {&CrowdPass::shadow_, {"shadow.vert", "shadow.frag", {}}},
  };
  for (const Wanted& each : wanted) {
    const Result<ProgramHandle> program = shaders.load(each.files);
    if (!program) return program.error();
    pass.*each.program = *program;
  }
  return pass;
}

DrawCounts CrowdPass::draw(const CrowdFrame& frame, const CrowdMesh& mesh, const PaletteBuffer& palettes) {
  test_depth();
  return frame.bones_as_lines ? draw_bones(frame, mesh, palettes) : draw_surfaces(frame, mesh, palettes);
}

DrawCounts CrowdPass::draw_surfaces(const CrowdFrame& frame, const CrowdMesh& mesh, const PaletteBuffer& palettes) {
  compose_surfaces(frame.batches, mesh, surfaces_);
  surfaces_.upload();
  for (const IndirectDraws::Group& group : surfaces_.groups()) {
    use_material(mesh.material(group.material));
    mesh.bind();
    palettes.bind(group.page, palette_binding);
    surfaces_.draw(group);
  }
  glDisable(GL_CULL_FACE);
  return surfaces_.counts();
}

void CrowdPass::use_material(const CrowdMaterial& material) const {
  const bool cut_out = material.alpha_cutoff > 0.0F;
  glUseProgram(shaders_->id(cut_out ? cut_out_ : opaque_));
  glUniform4fv(base_color_location, 1, material.base_color);
  if (cut_out) glUniform1f(alpha_cutoff_location, material.alpha_cutoff);
  glBindTextureUnit(0, material.texture);
  if (material.double_sided) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
  }
}

DrawCounts CrowdPass::draw_bones(const CrowdFrame& frame, const CrowdMesh& mesh, const PaletteBuffer& palettes) const {
  DrawCounts counts;
  if (mesh.bone_end_count() == 0) return counts;
  glUseProgram(shaders_->id(bones_));
  mesh.bind();
  for_each_page(frame.batches, [&](std::span<const CrowdBatch> page) {
    palettes.bind(page.front().page, palette_binding);
    const std::uint32_t first = page.front().first_instance;
    const std::uint32_t end = page.back().first_instance + page.back().instance_count;
    glDrawArraysInstancedBaseInstance(GL_LINES, static_cast<GLint>(mesh.first_bone_end()),
                                      static_cast<GLsizei>(mesh.bone_end_count()), static_cast<GLsizei>(end - first),
                                      first);
    ++counts.draw_calls;
  });
  return counts;
}

DrawCounts CrowdPass::draw_shadows(const CrowdFrame& frame, const CrowdMesh& mesh, const PaletteBuffer& palettes) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glUseProgram(shaders_->id(shadow_));
  mesh.bind();
  compose_outlines(frame.batches, mesh, outlines_);
  outlines_.upload();
  for (const IndirectDraws::Group& group : outlines_.groups()) {
    palettes.bind(group.page, palette_binding);
    outlines_.draw(group);
  }
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  return outlines_.counts();
}

}  // namespace throng::render
