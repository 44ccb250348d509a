#include "engine/render/passes/crowd_pass.h"

#include <algorithm>
#include <utility>

#include "engine/render/frame/frame_data.h"

namespace throng::render {
namespace {

/// Locations of uniforms, the same in every program of the crowd; CrowdMesh::bind sets 0.
enum Location : GLint { base_color_location = 1, alpha_cutoff_location = 2 };

/// Calls `do_run` with all batches of each page and character.
void for_each_run(std::span<const CrowdBatch> batches, const auto& do_run) {
  while (!batches.empty()) {
    const CrowdBatch& first = batches.front();
    const auto other = std::ranges::find_if(batches, [&](const CrowdBatch& batch) {
      return batch.page != first.page || batch.character != first.character;
    });
    const auto count = static_cast<std::size_t>(other - batches.begin());
    do_run(batches.first(count));
    batches = batches.subspan(count);
  }
}

void compose_surfaces(std::span<const CrowdBatch> batches, std::span<const CrowdMesh> meshes, IndirectDraws& draws) {
  draws.clear();
  for_each_run(batches, [&](std::span<const CrowdBatch> run) {
    const auto [page, character] = std::pair(run[0].page, run[0].character);
    const CrowdMesh& mesh = meshes[character];
    for (std::size_t material = 0; material < mesh.material_count(); ++material) {
      draws.begin_group(page, character, static_cast<int>(material));
      for (const CrowdBatch& batch : run) {
        for (const MaterialRun& triangles : mesh.runs(batch.mesh_lod)) {
          if (triangles.material == static_cast<int>(material)) draws.add(triangles, batch);
        }
      }
    }
  });
}

void compose_outlines(std::span<const CrowdBatch> batches, std::span<const CrowdMesh> meshes, IndirectDraws& draws) {
  draws.clear();
  for_each_run(batches, [&](std::span<const CrowdBatch> run) {
    const CrowdMesh& mesh = meshes[run[0].character];
    draws.begin_group(run[0].page, run[0].character, 0);
    for (const CrowdBatch& batch : run) {
      // The next coarser mesh LOD has enough triangles for an outline.
      const std::size_t lod = std::min<std::size_t>(batch.mesh_lod + 1UL, mesh.lod_count() - 1);
      for (const MaterialRun& triangles : mesh.runs(lod)) draws.add(triangles, batch);
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

CrowdPass::CrowdPass(ShaderLibrary& shaders)
    : opaque_(shaders.load({"crowd.vert", "crowd.frag"})),
      cut_out_(shaders.load({"crowd.vert", "crowd_cut_out.frag"})),
      bones_(shaders.load({"crowd.vert", "bones.frag"})),
      shadow_(shaders.load({"shadow.vert", "shadow.frag"})) {}

DrawCounts CrowdPass::draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes) {
  test_depth();
  return frame.bones_as_lines ? draw_bones(frame, meshes, palettes) : draw_surfaces(frame, meshes, palettes);
}

DrawCounts CrowdPass::draw_surfaces(const CrowdFrame& frame, std::span<const CrowdMesh> meshes,
                                    const PaletteBuffer& palettes) {
  compose_surfaces(frame.batches, meshes, surfaces_);
  surfaces_.upload();
  for (const IndirectDraws::Group& group : surfaces_.groups()) {
    const CrowdMesh& mesh = meshes[group.character];
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
  glUseProgram(cut_out ? cut_out_.id() : opaque_.id());
  glUniform4fv(base_color_location, 1, material.base_color);
  if (cut_out) glUniform1f(alpha_cutoff_location, material.alpha_cutoff);
  glBindTextureUnit(0, material.texture);
  if (material.double_sided) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
  }
}

DrawCounts CrowdPass::draw_bones(const CrowdFrame& frame, std::span<const CrowdMesh> meshes,
                                 const PaletteBuffer& palettes) const {
  DrawCounts counts;
  glUseProgram(bones_.id());
  for_each_run(frame.batches, [&](std::span<const CrowdBatch> run) {
    const CrowdMesh& mesh = meshes[run.front().character];
    if (mesh.bone_end_count() == 0) return;
    mesh.bind();
    palettes.bind(run.front().page, palette_binding);
    const std::uint32_t first = run.front().first_instance;
    const std::uint32_t end = run.back().first_instance + run.back().instance_count;
    glDrawArraysInstancedBaseInstance(GL_LINES, static_cast<GLint>(mesh.first_bone_end()),
                                      static_cast<GLsizei>(mesh.bone_end_count()), static_cast<GLsizei>(end - first),
                                      first);
    ++counts.draw_calls;
  });
  return counts;
}

DrawCounts CrowdPass::draw_shadows(const CrowdFrame& frame, std::span<const CrowdMesh> meshes,
                                   const PaletteBuffer& palettes) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glUseProgram(shadow_.id());
  compose_outlines(frame.batches, meshes, outlines_);
  outlines_.upload();
  for (const IndirectDraws::Group& group : outlines_.groups()) {
    meshes[group.character].bind();
    palettes.bind(group.page, palette_binding);
    outlines_.draw(group);
  }
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  return outlines_.counts();
}

}  // namespace throng::render
