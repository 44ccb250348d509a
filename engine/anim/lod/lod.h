#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/skip_error.h"
#include "engine/anim/base/executor.h"
#include "engine/anim/lod/lod_cost.h"

/// Who is updated this frame, how far ahead, and with how many bones: the paper's LOD by skipping updates and by
/// dropping bones. Decided from bounds and camera numbers before any animation; depends on nothing but its inputs.
namespace throng::anim {

enum class LodRule : std::uint8_t {
  off,       ///< every agent, seen or not, is posed every frame
  distance,  ///< the farther from the camera, the longer the interval between updates
  budget,    ///< whatever is cheapest whose predicted error on screen is within a tolerance
};

inline constexpr int longest_interval = 16;  ///< frames

/// The knobs of the rule; a change takes effect for each agent at its next update, or at once after
/// `LodState::make_all_due`. Distances are from the camera to the
/// centre of the agent's bounds; one that is exactly at a distance is beyond it.
struct LodRules {
  LodRule rule = LodRule::distance;
  float full_rate_distance = 12.0F;  ///< metres: nearer agents are updated each frame
  float interval_growth = 12.0F;     ///< metres for each further frame of the interval; above 0
  int largest_interval = 8;          ///< frames, 1 to longest_interval
  bool bone_lod = true;              ///< fewer bones by distance, whatever the rule
  std::array<float, max_bone_levels - 1> level_distances{15.0F, 30.0F, 60.0F};  ///< metres, ascending
  // LodRule::budget, which reads neither distances nor interval_growth
  float tolerance_pixels = 1.0F;    ///< an agent's error on screen, over its importance; above 0
  float centre_importance = 1.25F;  ///< of those within centre_degrees of the middle of the picture
  float centre_degrees = 8.0F;
  bool smooth = true;        ///< skipped frames blend (smooth skipping)
  bool counts_cost = false;  ///< LodCost::by_tolerance is asked for

  friend bool operator==(const LodRules&, const LodRules&) = default;
};

/// Overrules the rule, to see what an interval or a level looks like; for an agent in view, from its next update on.
struct LodForce {
  int interval = 0;     ///< frames, 1 to longest_interval; 0: as the rule has it
  int bone_level = -1;  ///< 0 to the character's last, or that one if there are fewer; -1: as the rule has it
  std::optional<std::uint32_t> agent = {};  ///< only this one; nothing: everyone

  [[nodiscard]] bool concerns(std::size_t other) const { return !agent || *agent == other; }
};

/// What the rule needs to know of the camera.
struct LodCamera {
  glm::vec3 position{0.0F};              ///< metres, world space
  std::array<glm::vec4, 6> frustum{};    ///< unit normal, offset: inside where dot(normal, point) + offset >= 0
  float pixels_per_unit = 1.0F;          ///< pixels that one metre covers at a distance of one metre
  glm::vec3 forward{0.0F, 0.0F, -1.0F};  ///< unit
};

/// What the rule needs to know of a character: a sphere about the vertical axis that holds every pose, its height and
/// its bone levels. All scaled with the agent.
struct LodCharacter {
  float centre_height = 0.9F;                                       ///< metres above the feet
  float radius = 1.2F;                                              ///< metres
  float height = 1.8F;                                              ///< metres, of the standing character
  int level_count = max_bone_levels;                                ///< 1 to max_bone_levels
  std::array<float, max_bone_levels> level_error_metres{};          ///< what a level is off on its surface, [0] is 0
  std::array<std::uint32_t, max_bone_levels> update_nanoseconds{};  ///< of one PU, an update at a level
  std::uint32_t full_rate_nanoseconds = 0;                          ///< and more of who has all bones in each frame
  std::span<const SkipError> clips = {};                            ///< what skipping costs, by clip
};

/// An agent in view, in ascending order of `agent`.
struct VisibleAgent {
  std::uint32_t agent;
  float pixels_tall;
  std::uint8_t interval;    ///< frames from one update to the next
  std::uint8_t bone_level;  ///< 0: all bones
};

/// An agent to be posed this frame, in ascending order of `agent`.
struct DueAgent {
  std::uint32_t agent;
  std::uint8_t look_ahead;  ///< frames until its next update, 1 to longest_interval
  std::uint8_t bone_level;
};

/// What was decided for one frame, in memory for every agent that `LodState::resize` sets aside. Not to be copied.
struct LodSelection {
  std::span<VisibleAgent> visible;
  std::span<DueAgent> due;
  LodCost cost;  ///< where LodFrame::choices are given

  std::vector<VisibleAgent> room_for_visible;  ///< [agents]
  std::vector<DueAgent> room_for_due;          ///< [agents]

  LodSelection() = default;
  LodSelection(const LodSelection&) = delete;
  LodSelection& operator=(const LodSelection&) = delete;
};

/// What the rule remembers of each agent between frames.
struct LodState {
  std::vector<std::uint64_t> next_update;  ///< frame number
  std::vector<std::uint8_t> interval;      ///< frames
  std::vector<std::uint8_t> bone_level;
  std::vector<std::uint8_t> frames_seen;  ///< without a break: 0, 1, or 2 and more
  std::vector<std::uint8_t> is_called;    ///< due out of turn

  /// Sizes state and `selection` for `agents` and forgets everything: whoever is visible next is due at once.
  void resize(std::size_t agents, LodSelection& selection);
  /// Whoever is visible next is due at once.
  void make_all_due();
  /// If it is visible next, it is due at once, for the pose of that very frame: its graph has changed.
  void make_due(std::size_t agent) { is_called[agent] = 1; }
};

class LodChoices;

/// Everything about one frame of a crowd; spans but `characters` are parallel, one element an agent.
struct LodFrame {
  std::span<const glm::vec3> positions;  ///< metres, world space, between the feet
  std::span<const float> scales;
  std::span<const LodCharacter> characters;    ///< empty: everybody is a LodCharacter as it is
  std::span<const std::uint8_t> character_of;  ///< index among them; empty: everybody is the first
  std::span<const int> clips;                  ///< index among the character's, below 0: stands still; empty: all 0
  std::span<const float> importance;           ///< above 0, 1: as the rules say, 2: half the error; empty: all 1
  std::span<const std::uint8_t> changing;      ///< 1: from one clip to another, LodChoices::changing; empty: nobody
  const LodChoices* choices = nullptr;         ///< of `characters`; null: no cost is counted, and no LodRule::budget
  LodCamera camera;
  LodRules rules;
  LodForce force = {};       ///< the interval of it is for rules other than off
  std::uint64_t number = 0;  ///< grows by one each frame in which time passes
};

/// Decides for every agent. An agent that comes into view, or was made due, is due at once, for the pose of this very
/// frame, and again in the next, from where it looks ahead; interval and bone level change only at an update, and the
/// first update after a change is moved forward to a frame where `number % interval` equals `agent % interval`, so that
/// the work of each frame is even. Allocates nothing, and each agent is decided alone.
void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection);

/// The same, tiles of agents shared out over `jobs` jobs.
void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection, Executor& executor, int jobs);

}  // namespace throng::anim
