#include "engine/render/passes/indirect_draws.h"

#include <algorithm>

namespace throng::render {
namespace {

// Parts of fewer triangles, or more parts, cost more than they gain.
constexpr std::uint64_t least_part = 10'000, most_parts = 8;

std::uint64_t triangles_of(const DrawCommand& command) {
  return std::uint64_t{command.index_count / 3} * command.instance_count;
}

std::uint64_t sum_of_triangles(std::span<const DrawCommand> commands) {
  std::uint64_t sum = 0;
  for (const DrawCommand& command : commands) sum += triangles_of(command);
  return sum;
}

}  // namespace

void IndirectDraws::clear() {
  commands_.clear();
  groups_.clear();
}

void IndirectDraws::begin_group(std::uint32_t page, std::uint8_t character, int material, bool is_dressed) {
  groups_.push_back({page, character, material, static_cast<std::uint32_t>(commands_.size()), 0, is_dressed});
}

void IndirectDraws::add(const MaterialRun& run, const CrowdBatch& batch) {
  commands_.push_back({run.index_count, batch.count, run.first_index, 0, batch.first});
  ++groups_.back().command_count;
}

void IndirectDraws::upload() {
  if (calls_ == Calls::some) cut_commands();
  buffer_.upload(commands_);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer_.id());
}

void IndirectDraws::cut_commands() {
  part_ = std::max(least_part, sum_of_triangles(commands_) / most_parts);
  cut_.clear();
  for (Group& group : groups_) {
    const auto first = static_cast<std::uint32_t>(cut_.size());
    for (DrawCommand command : std::span(commands_).subspan(group.first_command, group.command_count)) {
      const std::uint64_t of_instance = std::max(command.index_count / 3, 1U);
      const auto most = static_cast<std::uint32_t>(std::max<std::uint64_t>(part_ / of_instance, 1));
      for (std::uint32_t left = command.instance_count; left > 0; left -= command.instance_count) {
        command.instance_count = std::min(left, most);
        cut_.push_back(command);
        command.first_instance += command.instance_count;
      }
    }
    group.first_command = first;
    group.command_count = static_cast<std::uint32_t>(cut_.size()) - first;
  }
  std::swap(commands_, cut_);
}

std::uint32_t IndirectDraws::end_of_part(const Group& group, std::uint32_t first) const {
  const std::uint32_t end = group.first_command + group.command_count;
  std::uint64_t triangles = 0;
  while (first < end && triangles < part_) triangles += triangles_of(commands_[first++]);
  return first;
}

void IndirectDraws::draw(const Group& group) const {
  const std::uint32_t end = group.first_command + group.command_count;
  for (std::uint32_t first = group.first_command; first < end;) {
    const std::uint32_t next = end_of_part(group, first);
    const std::uintptr_t offset = std::uintptr_t{first} * sizeof(DrawCommand);
    // OpenGL takes an offset into the bound buffer as a pointer.
    const void* const commands = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, commands, static_cast<GLsizei>(next - first),
                                sizeof(DrawCommand));
    if (calls_ == Calls::some) glFlush();
    first = next;
  }
}

DrawCounts IndirectDraws::counts() const {
  DrawCounts counts{.triangles = sum_of_triangles(commands_)};
  for (const Group& group : groups_) {
    const std::uint32_t end = group.first_command + group.command_count;
    for (std::uint32_t first = group.first_command; first < end; first = end_of_part(group, first)) {
      ++counts.draw_calls;
    }
  }
  return counts;
}

}  // namespace throng::render
