#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "throng/camera.h"
#include "throng/host.h"
#include "throng/lod_rules.h"

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/skip_error.h"
#include "engine/anim/lod/lod_cost.h"

/// Decides which agents are updated this frame, how far ahead, and with how many bones: the paper's level of detail by
/// skipping updates and by dropping bones. It runs before any animation and depends on bounds, camera numbers and its
/// other inputs alone.
namespace throng::anim {

/// A character, as far as the rule reads it: a sphere that holds every pose, its height and its bone levels. Lengths
/// are multiplied by the agent's scale.
struct LodCharacter {
  float centre_height = 0.9F;                                       ///< metres, centre of the sphere above the feet
  float radius = 1.2F;                                              ///< metres
  float height = 1.8F;                                              ///< metres, of the standing character
  int level_count = max_bone_levels;                                ///< 1 to max_bone_levels
  std::array<float, max_bone_levels> level_error_metres{};          ///< how far the surface of a level is off; [0] is 0
  std::array<std::uint32_t, max_bone_levels> update_nanoseconds{};  ///< time of one PU for an update at a level
  std::uint32_t full_rate_nanoseconds = 0;                          ///< on top, with all bones in every frame
  std::span<const SkipError> clips = {};                            ///< the error of skipping, one a clip
};

/// An agent in view.
struct VisibleAgent {
  std::uint32_t agent;
  float pixels_tall;
  std::uint8_t interval;    ///< frames from one update to the next
  std::uint8_t bone_level;  ///< 0: all bones
};

/// The decisions of one frame. Both lists ascend by agent. LodState::resize makes room for every agent.
struct LodSelection {
  std::span<VisibleAgent> visible;
  std::span<std::uint32_t> due;  ///< the agents to be posed this frame; LodState has their levels and next updates
  LodCost cost;                  ///< counted where LodFrame::choices are given

  std::vector<VisibleAgent> room_for_visible;  ///< [agents]
  std::vector<std::uint32_t> room_for_due;     ///< [agents]

  LodSelection() = default;
  // The lists of a copy lie in its own room.
  LodSelection(const LodSelection& other)
      : cost(other.cost), room_for_visible(other.room_for_visible), room_for_due(other.room_for_due) {
    visible = std::span(room_for_visible).first(other.visible.size());
    due = std::span(room_for_due).first(other.due.size());
  }
  LodSelection& operator=(const LodSelection&) = delete;
};

/// Keeps what the rule remembers of each agent between frames.
struct LodState {
  std::vector<std::uint64_t> next_update;  ///< turn; the turn of the last update means the next frame
  std::vector<std::uint8_t> interval;      ///< frames
  std::vector<std::uint8_t> bone_level;
  std::vector<std::uint8_t> frames_seen;  ///< frames in a row: 0, 1, or 2 for more
  std::vector<std::uint8_t> is_called;    ///< due out of turn

  /// Sizes state and `selection` for `agents` and forgets everything, so that each agent is due when next visible.
  void resize(std::size_t agents, LodSelection& selection);
  /// Makes each agent due when next visible.
  void make_all_due();
  /// Makes an agent due when next visible, for the pose of the same frame, since its graph has changed.
  void make_due(std::size_t agent) { is_called[agent] = 1; }
};

class LodChoices;

/// One frame of a crowd. All spans but `characters` are parallel, one element an agent.
struct LodFrame {
  std::span<const glm::vec3> positions;  ///< metres, world space, between the feet
  std::span<const float> scales;
  std::span<const LodCharacter> characters;    ///< empty: every agent is a default LodCharacter
  std::span<const std::uint8_t> character_of;  ///< index into `characters`; empty: every agent is the first
  std::span<const int> clips;                  ///< index of the character's clips; below 0: stands still; empty: all 0
  std::span<const float> importance;           ///< above 0; 1: as the rules say, 2: half the error; empty: all 1
  std::span<const std::uint8_t> changing;     ///< 1: goes over to another clip (LodChoices::changing); empty: none does
  std::span<const std::uint8_t> absent = {};  ///< 1: neither seen nor due; empty: every agent is there
  const LodChoices* choices = nullptr;        ///< of `characters`; null: counts no cost, and forbids LodRule::budget
  Camera camera;
  LodRules rules;                 ///< its limits are not read
  float tolerance_pixels = 1.0F;  ///< LodRule::budget: the error that an agent of importance 1 may have; above 0
  bool counts_cost = false;       ///< true: LodCost::by_tolerance is counted
  LodForce force = {};            ///< LodRule::off ignores its interval
  std::uint64_t number = 0;       ///< the turn: it grows with time, by one a frame where frames are of one length
  bool stands_still = false;      ///< no time has passed since the frame before
};

/// Decides for every agent. An agent that comes into view or was made due is due at once, for the pose of this frame,
/// and again in the next frame in which time passes; from then on it looks ahead. Interval and bone level change
/// at updates only. After a change the first update comes early, at a turn where `number % interval` equals `agent %
/// interval`, so that all frames have about the same work. Allocates nothing. No agent's decision depends on another's.
void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection);

/// Decides in tiles of agents, in up to `jobs` jobs.
void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection, Executor& executor, int jobs);

}  // namespace throng::anim
