#include "engine/render/crowd_pass.h"

#include <algorithm>

#include "engine/render/frame_uniforms.h"

namespace throng::render {
namespace {

/// Uniform locations, the same in every program of the crowd.
enum Location : GLint { first_instance_location = 0, base_color_location = 1, alpha_cutoff_location = 2 };

const void* index_offset(std::uint32_t first_index) {
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first_index) * sizeof(std::uint32_t));
}

void bind_batch(const CrowdBatch& batch, const CrowdMesh& mesh, const PaletteBuffer& palettes) {
  palettes.bind(batch.page, palette_binding);
  glBindVertexArray(mesh.vertex_array(batch.bone_level));
}

void draw_run(const MaterialRun& run, const CrowdBatch& batch, DrawCounts& counts) {
  glUniform1ui(first_instance_location, batch.first_instance);
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(run.index_count), GL_UNSIGNED_INT,
                          index_offset(run.first_index), static_cast<GLsizei>(batch.instance_count));
  ++counts.draw_calls;
  counts.triangles += std::uint64_t{run.index_count / 3} * batch.instance_count;
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

DrawCounts CrowdPass::draw(const CrowdFrame& frame, const CrowdMesh& mesh, const PaletteBuffer& palettes) const {
  test_depth();
  return frame.bones_as_lines ? draw_bones(frame, mesh, palettes) : draw_surfaces(frame, mesh, palettes);
}

DrawCounts CrowdPass::draw_surfaces(const CrowdFrame& frame, const CrowdMesh& mesh,
                                    const PaletteBuffer& palettes) const {
  DrawCounts counts;
  for (const CrowdBatch& batch : frame.batches) {
    bind_batch(batch, mesh, palettes);
    for (const MaterialRun& run : mesh.runs(batch.mesh_lod)) {
      use_material(mesh.material(run.material));
      draw_run(run, batch, counts);
    }
  }
  glDisable(GL_CULL_FACE);
  return counts;
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
  for (const CrowdBatch& batch : frame.batches) {
    bind_batch(batch, mesh, palettes);
    glUniform1ui(first_instance_location, batch.first_instance);
    glDrawArraysInstanced(GL_LINES, static_cast<GLint>(mesh.first_bone_end()),
                          static_cast<GLsizei>(mesh.bone_end_count()), static_cast<GLsizei>(batch.instance_count));
    ++counts.draw_calls;
  }
  return counts;
}

DrawCounts CrowdPass::draw_shadows(const CrowdFrame& frame, const CrowdMesh& mesh,
                                   const PaletteBuffer& palettes) const {
  DrawCounts counts;
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glUseProgram(shaders_->id(shadow_));
  for (const CrowdBatch& batch : frame.batches) {
    bind_batch(batch, mesh, palettes);
    // An outline needs no more triangles than the next coarser mesh LOD has.
    const std::size_t lod = std::min<std::size_t>(batch.mesh_lod + 1UL, mesh.lod_count() - 1);
    for (const MaterialRun& run : mesh.runs(lod)) draw_run(run, batch, counts);
  }
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  return counts;
}

}  // namespace throng::render
