#include "engine/render/passes/skinning_read_back.h"

#include "engine/render/frame/frame_uniforms.h"

namespace throng::render {
namespace {

static_assert(sizeof(ReadBackVertex) == 24);

}  // namespace

Result<SkinningReadBack> SkinningReadBack::create(ShaderLibrary& shaders) {
  const Result<ProgramHandle> program =
      shaders.load({"skinning_read_back.vert", "", {"world_position", "world_normal"}});
  if (!program) return program.error();
  return SkinningReadBack(shaders, *program);
}

std::vector<ReadBackVertex> SkinningReadBack::read(const ReadBackAgent& agent, const CrowdMesh& mesh,
                                                   const PaletteBuffer& palettes) const {
  std::vector<ReadBackVertex> vertices(mesh.vertex_count());
  const gl::Buffer captured = gl::create_buffer();
  const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(ReadBackVertex));
  glNamedBufferStorage(captured.id(), bytes, nullptr, 0);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.id());
  palettes.bind(agent.page, palette_binding);
  glUseProgram(shaders_->id(program_));
  mesh.bind();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArraysInstancedBaseInstance(GL_POINTS, 0, static_cast<GLsizei>(vertices.size()), 1, agent.instance);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glGetNamedBufferSubData(captured.id(), 0, bytes, vertices.data());
  return vertices;
}

}  // namespace throng::render
