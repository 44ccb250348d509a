#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/kernel/palette/surface_error.h"
#include "engine/anim/lod/lod.h"
#include "engine/base/random.h"
#include "engine/crowd/shown_poses.h"

namespace throng {

/// An agent whose palettes are kept where they can be read, because the device's memory is only written
/// (engine/render).
struct WatchedAgent {
  static constexpr std::uint32_t no_agent = UINT32_MAX;
  static constexpr std::uint64_t never = UINT64_MAX - 1;

  std::uint32_t agent = no_agent;
  std::uint32_t frames_left = 0;
  std::byte* from = nullptr;  ///< the palette of the slot that the agent blends from; room for matrices
  std::byte* to = nullptr;    ///< the palette of the slot that the agent blends to; room for matrices
  PaletteFormat format{};     ///< the format of both
  bool blends = false;        ///< false: shows `to` alone
  bool from_known = false;
  bool to_known = false;
  PaletteSlot to_slot;
  std::byte* slot_memory = nullptr;  ///< the slot to which `to` goes after the update; null: it is there
  std::uint32_t entries = 0;         ///< the number of entries that are written to `to`
  anim::SurfaceErrors errors;        ///< the errors in the frame `measured_in`
  std::uint64_t measured_in = never;
  std::uint64_t measured_again_in = never;  ///< the second of a pair of frames

  bool can_be_measured() const { return agent != no_agent && to_known && (from_known || !blends); }
};

/// The agents that the meter watches: all in view, or some of them for a while, drawn by chance in proportion to their
/// height on screen.
class WatchedAgents {
 public:
  static constexpr std::size_t few = 64;
  static constexpr std::uint32_t few_frames = 48;

  /// Stops watching, and makes room for at most `watched` of the crowd's `agents`, with palettes of at most `entries`.
  void reset(std::size_t agents, std::size_t watched, std::size_t entries);

  /// Chooses the agents to watch. Call it before an update and after ShownPoses::hide_unseen, with the agents in view.
  void choose(std::span<const anim::VisibleAgent> visible, const ShownPoses& shown);

  /// Returns where the PU must write a new pose: `slot_memory`, or for a watched agent the memory that keeps the pose
  /// until hand_over().
  std::byte* destination(std::uint32_t agent, const ShownPose& pose, std::uint32_t entries, std::byte* slot_memory);
  /// Copies the written palettes into their slots. Call it after an update.
  void hand_over();

  std::span<WatchedAgent> all() { return watched_; }
  std::span<const WatchedAgent> all() const { return watched_; }

 private:
  void watch(std::uint32_t agent);
  void stop(WatchedAgent& watched);
  void fill_by_height(std::span<const anim::VisibleAgent> visible);

  std::vector<WatchedAgent> watched_;
  std::vector<std::uint32_t> free_;      // places in watched_
  std::vector<std::uint32_t> place_of_;  // [agent] in watched_, or no_agent
  std::vector<float> lots_;
  anim::AlignedBytes palettes_;
  Random random_{1, 0x6d65746572};
};

}  // namespace throng
