#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/settings/settings.h"
#include "engine/anim/base/units.h"
#include "engine/anim/lod/lod.h"
#include "engine/anim/lod/lod_choices.h"
#include "engine/anim/lod/lod_controller.h"
#include "engine/anim/run/program/cost_model.h"

namespace throng::app {

/// What the rule is made ready from in a frame.
struct LodPreparation {
  anim::LodRules rules;  ///< tolerance_pixels and counts_cost are put in
  anim::Ticks now = 0;
  anim::Ticks frame_step = 0;  ///< 0: time stands still
};

/// What one frame's level of detail came to.
struct LodFigures {
  float tolerance_px = 0.0F;  ///< 0 under rules that have none
  anim::BindingLimit binding = anim::BindingLimit::none;
  double predicted_ms = 0.0;       ///< of all PUs
  bool budget_held = true;         ///< those who reappear exempt; true without a budget
  std::optional<bool> error_held;  ///< none: no such limit, or nothing measured yet
  anim::LodCost cost;
};

/// Everything about level of detail that lasts longer than a frame: what skipping costs each character, who matters
/// more than others, and the tolerance.
class CrowdLod {
 public:
  /// At first, and whenever one of them has other levels; `characters` outlive this.
  void set_characters(std::span<anim::LodCharacter> characters);

  /// The crowd starts anew.
  void reset(std::size_t agents, const Tuning& tuning);
  /// An agent changes clip until then: its pose moves more than either clip does.
  void fade(std::uint32_t agent, anim::Ticks until);

  /// Before a frame's selection.
  void prepare(const LodPreparation& moment, std::optional<std::uint32_t> selected);
  const anim::LodRules& rules() const { return rules_; }
  const anim::LodChoices& choices() const { return choices_; }
  std::span<const float> importance() const { return importance_; }
  std::span<const std::uint8_t> changing() const { return changing_; }

  /// With a budget, in the first frame, whose tolerance is not known until its selection has said what it would cost:
  /// then it has another one, and whoever was selected is to be selected again.
  bool begin(const Tuning& tuning, const anim::LodCost& cost);
  /// After a frame was posed: the tolerance of the next.
  void settle(const Tuning& tuning, const anim::LodCost& cost, double predicted_nanoseconds, bool moving);
  void tell_measured_error(std::optional<float> pixels) { measured_error_ = pixels; }

  /// Of the last frame that was settled.
  const LodFigures& figures() const { return figures_; }

 private:
  void weigh(anim::Ticks now, std::optional<std::uint32_t> selected);
  bool must_build(const LodPreparation& moment) const;

  std::span<anim::LodCharacter> characters_;
  anim::LodRules rules_, built_for_;
  double built_seconds_ = 0.0;  // a frame
  anim::LodChoices choices_;
  anim::LodController controller_;
  std::vector<float> importance_;         // [agent]
  std::vector<std::uint8_t> changing_;    // [agent] 1: fades
  std::vector<anim::Ticks> fades_until_;  // [agent]
  std::vector<std::uint32_t> fading_;     // agents
  std::optional<std::uint32_t> selected_;
  std::optional<float> measured_error_;
  LodFigures figures_;
};

/// What an update at each level costs one PU, nanoseconds, for a character that plays one clip.
std::array<std::uint32_t, anim::max_bone_levels> update_costs(const anim::Skeleton& skeleton,
                                                              const anim::CostModel& cost);

/// "none", "error", "budget", "both miss".
const char* name_of(anim::BindingLimit limit);

}  // namespace throng::app
