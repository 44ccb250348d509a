#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "throng/host.h"
#include "throng/render/instance_record.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/lod/level_of_detail.h"
#include "engine/base/compiler.h"
#include "engine/base/gathered.h"
#include "engine/crowd/palette_slots.h"

namespace throng {

/// The two slots of an agent that its record names, and the times between which the shader goes from one to the other.
struct ShownPose {
  PaletteSlot from, to;
  std::uint8_t from_level = 0, to_level = 0;
  PaletteFormat from_format{}, to_format{};
  std::uint32_t from_time = 0;  ///< the moment of the pose `from`; microseconds modulo 2^32
  std::uint32_t to_time = 0;    ///< the moment of the pose `to`; equal to from_time: nothing blends

  bool shown() const { return to.valid(); }
  /// Returns the word by which the instance record names the slot `from`.
  std::uint32_t from_word() const { return slot_word(from, from_format); }
  /// Returns the word by which the instance record names the slot `to`.
  std::uint32_t to_word() const { return slot_word(to, to_format); }
  /// Returns the bone level of which both slots hold all entries.
  std::uint8_t level() const { return from_level > to_level ? from_level : to_level; }

 private:
  static std::uint32_t slot_word(const PaletteSlot& slot, PaletteFormat format) {
    return slot.first_line | (format == PaletteFormat::packed ? render::packed_slot : 0U);
  }
};

/// The poses of a view that a picture can be made of.
enum class Poses : std::uint8_t { shown, exact };

/// A pose that is about to be written.
struct NewPose {
  std::uint32_t agent;
  std::uint8_t level;     ///< bone level
  std::uint32_t entries;  ///< entries of the palette at that level
  std::uint32_t time;     ///< the moment of the pose; microseconds modulo 2^32
  PaletteFormat format = PaletteFormat::matrices;
};

/// Keeps the palette slots that each agent shows: the animation's side of the contract in engine/render/README.md.
class ShownPoses {
 public:
  explicit ShownPoses(PaletteSlots& slots) : slots_(&slots) {}

  /// Gives back everything shown, as of the last drawn frame, and makes room for `agents`.
  void reset(std::size_t agents, std::uint64_t last_frame);

  /// Gives back the slots of agents that are not in view any more. `jobs` run at once.
  void hide_unseen(const anim::LevelOfDetail& lod, std::uint64_t last_frame, Executor& executor, int jobs);
  /// Asks the caches for the pose of an agent, for which show() is called soon.
  THRONG_ALWAYS_INLINE void prefetch_pose(std::uint32_t agent) const { prefetch(&poses_[agent]); }

  /// Returns the memory of a slot for a new pose of a visible agent. The shader blends to it from the pose shown so
  /// far. A pose of `now` is shown at once. A pose of an agent that must move to another page is shown at once too;
  /// pose().to_time is then `now`, and the pose must be of now. Returns null where no memory is left: the agent is
  /// posed but not drawn.
  std::byte* show(const NewPose& next, std::uint32_t now, std::uint64_t last_frame);

  const ShownPose& pose(std::uint32_t agent) const { return poses_[agent]; }
  /// Returns the slots that the poses are in; others may take some too.
  PaletteSlots& slots() const { return *slots_; }
  /// Returns whether an agent found no slot since the last reset.
  bool out_of_memory() const { return out_of_memory_; }

 private:
  void hide(ShownPose& pose, std::uint64_t last_frame);
  void retire_from(ShownPose& pose, std::uint64_t last_frame);

  PaletteSlots* slots_;
  std::vector<ShownPose> poses_;
  std::vector<std::uint32_t> shown_;  // ascending agents
  Gathered<std::uint32_t> gone_;
  bool out_of_memory_ = false;
};

}  // namespace throng
