#include "app/lod/crowd_lod.h"

#include <algorithm>
#include <cmath>

#include "engine/anim/kernel/kernels.h"

namespace throng::app {
namespace {

constexpr float importance_of_selected = 4.0F;
constexpr float importance_of_fading = 2.0F;
constexpr double usual_frame_seconds = 1.0 / 60.0;
constexpr double longer_frame = 1.25;  // than that which choices were built for, or shorter: they are built anew
constexpr double nanoseconds_a_millisecond = 1e6;

// Rules but for the tolerance, which no choice depends on.
bool same_but_tolerance(anim::LodRules a, const anim::LodRules& b) {
  a.tolerance_pixels = b.tolerance_pixels;
  return a == b;
}

anim::LodLimits limits_of(const Tuning& tuning) {
  return {.error_pixels = tuning.error_px,
          .budget_nanoseconds = static_cast<double>(tuning.budget_ms) * nanoseconds_a_millisecond};
}

}  // namespace

void CrowdLod::set_characters(std::span<anim::LodCharacter> characters) {
  characters_ = characters;
  choices_ = {};
}

void CrowdLod::reset(std::size_t agents, const Tuning& tuning) {
  importance_.assign(agents, 1.0F);
  changing_.assign(agents, 0);
  fades_until_.assign(agents, 0);
  fading_.clear();
  fading_.reserve(agents);
  selected_.reset();
  measured_error_.reset();
  controller_.reset(limits_of(tuning));
}

void CrowdLod::fade(std::uint32_t agent, anim::Ticks until) {
  if (agent >= fades_until_.size()) return;  // the crowd is being made
  if (fades_until_[agent] == 0) fading_.push_back(agent);
  fades_until_[agent] = std::max<anim::Ticks>(until, 1);
}

void CrowdLod::weigh(anim::Ticks now, std::optional<std::uint32_t> selected) {
  if (selected_ && *selected_ < importance_.size()) importance_[*selected_] = 1.0F;
  const auto is_over = [&](std::uint32_t agent) {
    const bool over = fades_until_[agent] <= now;
    importance_[agent] = over ? 1.0F : importance_of_fading;
    changing_[agent] = over ? 0 : 1;
    if (over) fades_until_[agent] = 0;
    return over;
  };
  std::erase_if(fading_, is_over);
  selected_ = selected;
  if (selected_) importance_[*selected_] = importance_of_selected;
}

bool CrowdLod::must_build(const LodPreparation& moment) const {
  if (choices_.empty() || !same_but_tolerance(moment.rules, built_for_)) return true;
  if (moment.frame_step == 0) return false;
  const double ratio = anim::to_seconds(moment.frame_step) / built_seconds_;
  return ratio > longer_frame || ratio < 1.0 / longer_frame;
}

void CrowdLod::prepare(const LodPreparation& moment, std::optional<std::uint32_t> selected) {
  const bool by_error = moment.rules.rule == anim::LodRule::budget;
  if (must_build(moment)) {
    built_seconds_ = moment.frame_step > 0 ? anim::to_seconds(moment.frame_step) : usual_frame_seconds;
    built_for_ = moment.rules;
    choices_.build(characters_, moment.rules, static_cast<float>(built_seconds_));
  }
  rules_ = moment.rules;
  rules_.tolerance_pixels = controller_.tolerance_pixels();
  rules_.counts_cost = by_error;
  weigh(moment.now, selected);
}

bool CrowdLod::begin(const Tuning& tuning, const anim::LodCost& cost) {
  if (tuning.lod.rule != anim::LodRule::budget || tuning.budget_ms <= 0.0F || !controller_.is_new()) return false;
  controller_.begin(limits_of(tuning), cost.by_tolerance);
  rules_.tolerance_pixels = controller_.tolerance_pixels();
  return true;
}

void CrowdLod::settle(const Tuning& tuning, const anim::LodCost& cost, double predicted_nanoseconds, bool moving) {
  if (!moving) return;
  const bool by_error = tuning.lod.rule == anim::LodRule::budget;
  const auto exempt = static_cast<double>(cost.reappeared);
  const double counted = predicted_nanoseconds - exempt;
  const anim::LodLimits limits = limits_of(tuning);
  figures_ = {.tolerance_px = by_error ? controller_.tolerance_pixels() : 0.0F,
              .binding = anim::BindingLimit::none,
              .predicted_ms = predicted_nanoseconds / nanoseconds_a_millisecond,
              .budget_held = !by_error || tuning.budget_ms <= 0.0F || counted <= limits.budget_nanoseconds,
              .error_held = {},
              .cost = cost};
  if (!by_error) return;
  controller_.settle(limits, {.cost_by_tolerance = cost.by_tolerance,
                              .nanoseconds = counted,
                              .exempt_nanoseconds = exempt,
                              .measured_error_pixels = measured_error_});
  figures_.binding = controller_.binding();
  if (measured_error_ && tuning.error_px > 0.0F) figures_.error_held = *measured_error_ <= tuning.error_px;
}

std::array<std::uint32_t, anim::max_bone_levels> update_costs(const anim::Skeleton& skeleton,
                                                              const anim::CostModel& cost) {
  std::array<std::uint32_t, anim::max_bone_levels> costs{};
  for (std::size_t level = 0; level < skeleton.level_bone_counts.size(); ++level) {
    const int packets = anim::packets_for(skeleton.level_bone_counts[level]);
    const double tile = cost.of_tile(packets) / anim::widest_strip;
    costs[level] = static_cast<std::uint32_t>(cost.of_agent({.players = 1}, packets) + tile);
  }
  return costs;
}

const char* name_of(anim::BindingLimit limit) {
  switch (limit) {
    case anim::BindingLimit::none:
      return "none";
    case anim::BindingLimit::error:
      return "error";
    case anim::BindingLimit::budget:
      return "budget";
    case anim::BindingLimit::both_miss:
      break;
  }
  return "both miss";
}

}  // namespace throng::app
