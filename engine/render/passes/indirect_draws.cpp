#include "engine/render/passes/indirect_draws.h"

namespace throng::render {

void IndirectDraws::clear() {
  commands_.clear();
  groups_.clear();
}

void IndirectDraws::begin_group(std::uint32_t page, std::uint8_t character, int material) {
  groups_.push_back({page, character, material, static_cast<std::uint32_t>(commands_.size()), 0});
}

void IndirectDraws::add(const MaterialRun& run, const CrowdBatch& batch) {
  commands_.push_back({run.index_count, batch.instance_count, run.first_index, 0, batch.first_instance});
  ++groups_.back().command_count;
}

void IndirectDraws::upload() {
  buffer_.upload(commands_);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer_.id());
}

void IndirectDraws::draw(const Group& group) const {
  if (group.command_count == 0) return;
  const std::uintptr_t offset = std::uintptr_t{group.first_command} * sizeof(DrawCommand);
  // OpenGL takes an offset into the bound buffer as a pointer.
  const void* const commands = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, commands, static_cast<GLsizei>(group.command_count),
                              sizeof(DrawCommand));
}

DrawCounts IndirectDraws::counts() const {
  DrawCounts counts;
  for (const Group& group : groups_) counts.draw_calls += group.command_count == 0 ? 0U : 1U;
  for (const DrawCommand& command : commands_) {
    counts.triangles += std::uint64_t{command.index_count / 3} * command.instance_count;
  }
  return counts;
}

}  // namespace throng::render
