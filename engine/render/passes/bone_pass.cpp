#include "engine/render/passes/bone_pass.h"

#include "engine/render/frame/frame_data.h"
#include "engine/render/passes/crowd_runs.h"

namespace throng::render {
namespace {

/// Locations of uniforms; CrowdMesh::bind sets 0.
constexpr GLint reach_of_bones = 1, picture_of_bones = 2, opacity_of_bones = 3;

constexpr float seen_bones = 0.95F, hidden_bones = 0.14F;  // opacities

// A quarter of a skeleton's longest side is as thick as most bodies.
constexpr float reach_share = 0.25F;

std::uint32_t draw_bones_of_runs(const CrowdFrame& frame, std::span<const CrowdMesh> meshes,
                                 const PaletteBuffer& palettes) {
  std::uint32_t calls = 0;
  for_each_run(runs_of_instances(frame), [&](std::span<const CrowdBatch> run) {
    const CrowdMesh& mesh = meshes[run.front().character];
    if (mesh.bone_end_count() == 0) return;
    mesh.bind();
    palettes.bind(run.front().page, palette_binding);
    glUniform1f(reach_of_bones, reach_share * mesh.longest_side_of_bones());
    const std::uint32_t first = run.front().first;
    const std::uint32_t end = run.back().first + run.back().count;
    glDrawArraysInstancedBaseInstance(GL_LINES, static_cast<GLint>(mesh.first_bone_end()),
                                      static_cast<GLsizei>(mesh.bone_end_count()), static_cast<GLsizei>(end - first),
                                      first);
    ++calls;
  });
  return calls;
}

}  // namespace

DrawCounts BonePass::draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                          glm::ivec2 picture) const {
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glUseProgram(program_.id());
  glUniform2f(picture_of_bones, static_cast<float>(picture.x), static_cast<float>(picture.y));
  DrawCounts counts;
  const auto draw_where = [&](GLenum depth, float opacity) {
    glDepthFunc(depth);
    glUniform1f(opacity_of_bones, opacity);
    counts.draw_calls += draw_bones_of_runs(frame, meshes, palettes);
  };
  draw_where(GL_LESS, hidden_bones);  // depth is reversed; seen bones go over hidden bones
  draw_where(GL_GEQUAL, seen_bones);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  return counts;
}

}  // namespace throng::render
