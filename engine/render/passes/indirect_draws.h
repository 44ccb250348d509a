#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/crowd_draw.h"

#include "engine/render/gl/handles.h"
#include "engine/render/mesh/surface.h"

namespace throng::render {

/// One draw as glMultiDrawElementsIndirect reads it (OpenGL 4.5, 10.3.11).
///
///      0  indices of the run
///      4  instances
///      8  first index
///     12  added to each index: 0, because all mesh LODs share one set of vertices
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

/// Says in how many calls a group is drawn.
enum class Calls : std::uint8_t {
  one,   ///< all at once
  some,  ///< in parts of the whole pass, so that a processor fills the pixels of one while it moves vertices of the
         ///< next
};

/// Collects the draws of one pass in groups. A group shares all state and is one call, or some, however many mesh LODs
/// and instances it holds, so the number of calls does not grow with the crowd.
class IndirectDraws {
 public:
  explicit IndirectDraws(Calls calls = Calls::one) : calls_(calls) {}

  void clear();
  /// Starts a group; add() adds to the last one.
  void begin_group(std::uint32_t page, std::uint8_t character, int material, bool is_dressed = false);
  void add(const MaterialRun& run, const CrowdBatch& batch);

  /// Copies the commands to the device and binds them.
  void upload();

  struct Group {
    std::uint32_t page;
    std::uint8_t character;
    int material;
    std::uint32_t first_command;
    std::uint32_t command_count;
    bool is_dressed;
  };
  std::span<const Group> groups() const { return groups_; }

  /// Draws one group with the program, page and vertices that are bound. Call upload() before.
  void draw(const Group& group) const;

  /// Counts the added commands. Groups without commands are not drawn and do not count. Call upload() before.
  DrawCounts counts() const;

 private:
  /// Cuts commands by instances, so that none has more triangles than a part.
  void cut_commands();
  /// Returns the command after the part of a group that begins with `first`.
  std::uint32_t end_of_part(const Group& group, std::uint32_t first) const;

  Calls calls_;
  std::uint64_t part_ = UINT64_MAX;  // triangles, at least, of all parts but the last
  std::vector<DrawCommand> commands_;
  std::vector<DrawCommand> cut_;  // kept from frame to frame
  std::vector<Group> groups_;
  gl::GrowingBuffer<DrawCommand> buffer_;
};

}  // namespace throng::render
