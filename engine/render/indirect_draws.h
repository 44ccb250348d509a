#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/crowd_draw.h"
#include "engine/render/gl/handles.h"
#include "engine/render/surface.h"

namespace throng::render {

/// What glMultiDrawElementsIndirect reads (OpenGL 4.5, 10.3.11).
///
///      0  indices of the run
///      4  instances
///      8  first index
///     12  added to each index: 0, all mesh LODs share one set of vertices
///     16  first instance, gl_BaseInstanceARB in the shader
struct DrawCommand {
  std::uint32_t index_count;
  std::uint32_t instance_count;
  std::uint32_t first_index;
  std::int32_t base_vertex;
  std::uint32_t first_instance;
};
static_assert(sizeof(DrawCommand) == 20);
static_assert(offsetof(DrawCommand, first_instance) == 16);

/// The draws of one pass, in groups that share all state and are one call each, however many mesh LODs and instances
/// they hold: that is why the number of calls does not grow with the crowd.
class IndirectDraws {
 public:
  void clear();
  /// What is added from here on is one call.
  void begin_group(std::uint32_t page, std::uint8_t character, int material);
  void add(const MaterialRun& run, const CrowdBatch& batch);

  /// Copies the commands to the device and binds them.
  void upload();

  struct Group {
    std::uint32_t page;
    std::uint8_t character;
    int material;
    std::uint32_t first_command;
    std::uint32_t command_count;
  };
  std::span<const Group> groups() const { return groups_; }

  /// After upload: draws one group with the program, page and vertices that are bound.
  void draw(const Group& group) const;

  /// Of the commands added; groups without any are not drawn and do not count.
  DrawCounts counts() const;

 private:
  std::vector<DrawCommand> commands_;
  std::vector<Group> groups_;
  gl::Buffer buffer_;
  std::size_t capacity_ = 0;  // commands
};

}  // namespace throng::render
