#include "engine/render/passes/contact_pass.h"

namespace throng::render {
namespace {

constexpr GLint sun_side_location = 0;
constexpr GLsizei corners_of_a_disc = 4;

}  // namespace

Result<ContactPass> ContactPass::create(ShaderLibrary& shaders) {
  const Result<ProgramHandle> program = shaders.load({"contact.vert", "contact.frag", {}});
  if (!program) return program.error();
  return ContactPass(shaders, *program);
}

ContactPass::ContactPass(const ShaderLibrary& shaders, ProgramHandle program)
    : shaders_(&shaders), program_(program), no_vertices_(gl::create_vertex_array()) {}

DrawCounts ContactPass::draw(std::uint32_t instance_count, bool with_sun_side) const {
  if (instance_count == 0) return {};
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glUseProgram(shaders_->id(program_));
  glUniform1f(sun_side_location, with_sun_side ? 1.0F : 0.0F);
  glBindVertexArray(no_vertices_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, corners_of_a_disc, static_cast<GLsizei>(instance_count));
  glDisable(GL_BLEND);
  return {1, std::uint64_t{2} * instance_count};
}

}  // namespace throng::render
