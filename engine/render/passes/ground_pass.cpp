#include "engine/render/passes/ground_pass.h"

namespace throng::render {

Result<GroundPass> GroundPass::create(ShaderLibrary& shaders) {
  const Result<ProgramHandle> program = shaders.load({"ground.vert", "ground.frag", {}});
  if (!program) return program.error();
  return GroundPass(shaders, *program);
}

GroundPass::GroundPass(const ShaderLibrary& shaders, ProgramHandle program)
    : shaders_(&shaders), program_(program), no_vertices_(gl::create_vertex_array()) {}

void GroundPass::draw() const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glUseProgram(shaders_->id(program_));
  glBindVertexArray(no_vertices_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace throng::render
