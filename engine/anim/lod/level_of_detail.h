#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "throng/host.h"
#include "throng/pose_request.h"

#include "engine/anim/bake/character.h"
#include "engine/anim/base/units.h"
#include "engine/anim/lod/bone_step.h"
#include "engine/anim/lod/lod.h"
#include "engine/anim/lod/lod_choices.h"
#include "engine/anim/lod/lod_controller.h"
#include "engine/anim/lod/lod_importance.h"
#include "engine/anim/run/program/cost_model.h"

namespace throng::anim {

/// Returns a character as level of detail reads it. The character outlives the result.
LodCharacter lod_character(const Character& character, const CostModel& cost = {});

/// A crowd as level of detail reads it. The spans are parallel, one element an agent.
struct LodCrowd {
  std::span<const glm::vec3> positions;  ///< metres, world space, between the feet
  std::span<const float> scales;
  std::span<const std::uint8_t> character_of = {};  ///< index into the characters; empty: every agent is the first
  std::span<const int> clips = {};              ///< index of the character's clips; below 0: stands still; empty: all 0
  std::span<const std::uint8_t> left_out = {};  ///< 1: update_also() alone poses it; empty: no agent
  std::span<const std::uint8_t> absent = {};    ///< 1: it is not there, and neither seen nor posed; empty: no agent
};

/// The request of a program for one frame.
struct LodRequest {
  Camera camera;
  LodRules rules;
  LodForce force = {};
  std::optional<std::uint32_t> selected = {};  ///< an agent of the crowd that shows a quarter of the others' error
  Ticks now{};
  Ticks frame_step{};  ///< the time since the frame before; 0: time stands still
};

/// The outcome of a frame.
struct LodFigures {
  float tolerance_px = 0.0F;  ///< 0 under rules that have none
  BindingLimit binding = BindingLimit::none;
  double predicted_ms = 0.0;       ///< time of all PUs
  bool budget_held = true;         ///< agents that come into view are exempt; true without a budget
  std::optional<bool> error_held;  ///< none: no limit on the error, or nothing measured yet
  LodCost cost;
};

/// Decides level of detail for a crowd from frame to frame. It lists the agents to be posed, with bone level and
/// look-ahead, and keeps the state of each agent. It allocates in set_characters(), reset() and in the first
/// select() after the rules, or the mean length of frames by more than a quarter, have changed.
///
///     select(crowd, request, executor, jobs)   lists updates()
///     updates()[i].palette = ...            the program says where palettes go; null: the agent is not drawn
///     system.update(updates())
///     settle(...)                           learns what was shown and what it cost
class LevelOfDetail {
 public:
  /// Sets the characters. Call it at first, and when the levels of a character change. The agents keep their
  /// state.
  void set_characters(std::vector<LodCharacter> characters);

  /// Forgets every agent and makes room for `agents`. Time and turns go on.
  void reset(std::size_t agents, const LodRules& rules);
  /// Begins turns and figures as in the first frame; call reset() after it. Equal frames then get equal decisions.
  void restart();

  /// Notes that the agent goes over to another clip until `until`.
  void change_clip(std::uint32_t agent, Ticks until) { importance_.fade(agent, until); }
  /// Makes an agent, or all, due when next visible.
  void make_due(std::uint32_t agent) { state_.make_due(agent); }
  void make_all_due() { state_.make_all_due(); }
  /// Forgets which palettes are shown, so that no agent blends from a palette or fades between bone levels.
  void forget_shown();

  /// Decides for every agent, in up to `jobs` jobs. With a budget the first frame is decided twice, since only a
  /// decision counts what a tolerance costs.
  void select(const LodCrowd& crowd, const LodRequest& request, Executor& executor, int jobs);
  /// Returns the list for AnimationSystem::update. An agent that looks ahead is shown already: it blends from the
  /// shown palette to the new one, over `look_ahead`.
  std::span<PoseRequest> updates() { return updates_; }
  std::span<const PoseRequest> updates() const { return updates_; }
  /// Adds an agent of LodCrowd::left_out, with all bones and its present pose.
  PoseRequest& update_also(std::uint32_t agent);
  /// Changes an update whose palette cannot be blended to: it is shown at once, and the agent is due again in the next
  /// frame.
  void show_at_once(PoseRequest& update);

  /// Learns from the updates which palettes are shown, and from the rules the tolerance of the next frame.
  /// `measured_error_pixels` is LodOutcome's.
  void settle(double predicted_nanoseconds, std::optional<float> measured_error_pixels = {});

  const LodSelection& selection() const { return selection_; }
  /// Returns whether the agent was in view in the last selection. The answer holds until make_all_due().
  bool is_visible(std::uint32_t agent) const { return state_.frames_seen[agent] > 0; }
  bool is_shown(std::uint32_t agent) const { return shown_in_[agent] == frame_; }  ///< it has a palette
  /// Returns the decision at its last update.
  LodChoice choice(std::uint32_t agent) const { return {state_.interval[agent], state_.bone_level[agent]}; }
  const LodChoices& choices() const { return choices_; }
  /// Returns the figures of the last settled frame in which time passed.
  const LodFigures& figures() const { return figures_; }

 private:
  void build_choices(const LodRequest& request);
  void set_turn_length(Ticks length);
  void pass_time(Ticks frame_step);
  LodFrame frame(const LodCrowd& crowd) const;
  bool has_budget() const;
  bool find_first_tolerance();
  void go_on_showing(Executor& executor, int jobs);
  void list_updates(const LodCrowd& crowd);
  BoneStep step_bones(std::uint32_t agent);

  std::vector<LodCharacter> characters_;
  LodImportance importance_;
  LodChoices choices_;
  LodRules built_for_;
  LodController controller_;
  LodState state_;
  LodSelection selection_;
  LodRequest request_;       // the request of this frame
  std::uint64_t frame_ = 0;  // selections so far
  // A turn is as long as frames are on the average, so that poses are due in time where frames differ in length.
  std::uint64_t turn_ = 0;
  Ticks turn_length_{}, into_turn_{}, mean_frame_{};
  std::vector<std::uint64_t> shown_in_;  // [agent] the last frame in which it was shown
  std::vector<BoneStep> bone_steps_;     // [agent] the step of its last update
  std::vector<PoseRequest> updates_;
  LodFigures figures_;
};

}  // namespace throng::anim
