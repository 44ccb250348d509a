#include "engine/anim/lod/level_of_detail.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/base/run_jobs.h"

namespace throng::anim {
namespace {

constexpr double usual_frame_seconds = 1.0 / 60.0;
constexpr double longer_frame = 1.25;  // on the average than a turn, or shorter: choices are built anew
constexpr int frames_of_mean = 16;
constexpr std::uint64_t never_shown = UINT64_MAX;

bool have_same_choices(const LodRules& a, const LodRules& b) {
  return a.largest_interval == b.largest_interval && a.bone_lod == b.bone_lod && a.smooth == b.smooth;
}

// Returns nanoseconds of one PU for a character that plays one clip.
std::array<std::uint32_t, max_bone_levels> update_costs(const Skeleton& skeleton, const CostModel& cost) {
  std::array<std::uint32_t, max_bone_levels> costs{};
  for (std::size_t level = 0; level < skeleton.level_bone_counts.size(); ++level) {
    const int packets = packets_for(skeleton.level_bone_counts[level]);
    const double tile = cost.of_tile(packets) / widest_strip;
    costs[level] = static_cast<std::uint32_t>(cost.of_agent({.players = 1}, packets) + tile);
  }
  return costs;
}

}  // namespace

LodCharacter lod_character(const Character& character, const CostModel& cost) {
  return {.centre_height = static_cast<float>(character.bounds.height / 2.0),
          .radius = static_cast<float>(character.bounds.reach),
          .height = static_cast<float>(character.bounds.height),
          .level_count = static_cast<int>(character.skeleton.level_bone_counts.size()),
          .level_error_metres = character.bone_lod.level_error_metres,
          .update_nanoseconds = update_costs(character.skeleton, cost),
          .full_rate_nanoseconds = 0,
          .clips = character.skip_errors};
}

void LevelOfDetail::set_characters(std::vector<LodCharacter> characters) {
  characters_ = std::move(characters);
  choices_ = {};
}

void LevelOfDetail::reset(std::size_t agents, const LodRules& rules) {
  state_.resize(agents, selection_);
  importance_.reset(agents);
  controller_.reset(rules);
  shown_in_.assign(agents, never_shown);
  bone_steps_.assign(agents, {});
  updates_.clear();
  updates_.reserve(agents);
}

// Choices are built for the length of the frames so far, so they are forgotten too.
void LevelOfDetail::restart() {
  turn_ = 0;
  turn_length_ = into_turn_ = mean_frame_ = {};
  choices_ = {};
  figures_ = {};
}

void LevelOfDetail::forget_shown() {
  std::ranges::fill(shown_in_, never_shown);
  std::ranges::fill(bone_steps_, BoneStep{});
}

void LevelOfDetail::build_choices(const LodRequest& request) {
  const double ratio = turn_length_ == Ticks{} ? 0.0 : to_seconds(mean_frame_) / to_seconds(turn_length_);
  const bool same_frames = mean_frame_ == Ticks{} || (ratio <= longer_frame && ratio >= 1.0 / longer_frame);
  if (!choices_.empty() && have_same_choices(request.rules, built_for_) && same_frames) return;
  if (!same_frames) set_turn_length(mean_frame_);
  built_for_ = request.rules;
  const double seconds = turn_length_ > Ticks{} ? to_seconds(turn_length_) : usual_frame_seconds;
  choices_.build(characters_, request.rules, static_cast<float>(seconds));
}

// Agents that are on their way stay due when their blends end, to the nearest turn.
void LevelOfDetail::set_turn_length(Ticks length) {
  for (std::uint64_t& due : state_.next_update) {
    if (due <= turn_ || turn_length_ == Ticks{}) continue;
    const Ticks left = static_cast<std::int64_t>(due - turn_) * turn_length_ - into_turn_;
    due = turn_ + static_cast<std::uint64_t>((left + length / 2) / length);
  }
  turn_length_ = length;
  into_turn_ = {};
}

void LevelOfDetail::pass_time(Ticks frame_step) {
  if (turn_length_ == Ticks{}) return;
  into_turn_ += frame_step;
  turn_ += static_cast<std::uint64_t>(into_turn_ / turn_length_);
  into_turn_ %= turn_length_;
}

LodFrame LevelOfDetail::frame(const LodCrowd& crowd) const {
  return LodFrame{.positions = crowd.positions,
                  .scales = crowd.scales,
                  .characters = characters_,
                  .character_of = crowd.character_of,
                  .clips = crowd.clips,
                  .importance = importance_.of_agents(),
                  .changing = importance_.changing(),
                  .absent = crowd.absent,
                  .choices = &choices_,
                  .camera = request_.camera,
                  .rules = request_.rules,
                  .tolerance_pixels = controller_.tolerance_pixels(),
                  .counts_cost = has_budget(),
                  .force = request_.force,
                  .number = turn_,
                  .stands_still = request_.frame_step == Ticks{}};
}

void LevelOfDetail::select(const LodCrowd& crowd, const LodRequest& request, Executor& executor, int jobs) {
  assert(crowd.left_out.empty() || crowd.left_out.size() == shown_in_.size());
  assert(crowd.absent.empty() || crowd.absent.size() == shown_in_.size());
  assert(!request.selected || *request.selected < shown_in_.size());
  request_ = request;
  ++frame_;
  if (request.frame_step > Ticks{}) {
    mean_frame_ =
        mean_frame_ == Ticks{} ? request.frame_step : mean_frame_ + (request.frame_step - mean_frame_) / frames_of_mean;
  }
  build_choices(request);
  pass_time(request.frame_step);
  importance_.weigh(request.now, request.selected);
  select_for_update(frame(crowd), state_, selection_, executor, jobs);
  if (find_first_tolerance()) {
    state_.make_all_due();
    select_for_update(frame(crowd), state_, selection_, executor, jobs);
  }
  go_on_showing(executor, jobs);
  list_updates(crowd);
}

// An agent that was shown in the frame before and is still in view stays shown, until settle() says otherwise.
void LevelOfDetail::go_on_showing(Executor& executor, int jobs) {
  constexpr std::size_t agents_worth_a_job = 1024;
  const std::span<const VisibleAgent> visible = selection_.visible;
  run_ranges(executor, visible.size(), agents_worth_a_job, jobs, [&](std::size_t first, std::size_t end) {
    for (const VisibleAgent& each : visible.subspan(first, end - first)) {
      std::uint64_t& shown_in = shown_in_[each.agent];
      if (shown_in == frame_ - 1) shown_in = frame_;
    }
  });
}

// The controller reads what tolerances cost for a budget alone.
bool LevelOfDetail::has_budget() const {
  return request_.rules.rule == LodRule::budget && request_.rules.budget_milliseconds > 0.0;
}

bool LevelOfDetail::find_first_tolerance() {
  if (!has_budget() || !controller_.is_new()) return false;
  controller_.begin(request_.rules, selection_.cost.by_tolerance);
  return true;
}

void LevelOfDetail::list_updates(const LodCrowd& crowd) {
  updates_.clear();
  for (const std::uint32_t agent : selection_.due) {
    if (!crowd.left_out.empty() && crowd.left_out[agent] != 0) continue;
    const BoneStep bones = step_bones(agent);
    const auto turns = static_cast<std::int64_t>(state_.next_update[agent] - turn_);
    // An agent that is evaluated in each frame has the pose of now.
    const bool ahead = request_.rules.smooth && turns > 0 && is_shown(agent);
    updates_.push_back({.agent = {agent},
                        .level = bones.level,
                        .look_ahead = ahead ? turns * turn_length_ - into_turn_ : Ticks{},
                        .palette = nullptr,
                        .fade_level = bones.fade_level,
                        .fade_halves = bones.fade_halves});
  }
}

// An agent that is shown goes from level to level by steps. Another one, and all while time stands still, go at once.
BoneStep LevelOfDetail::step_bones(std::uint32_t agent) {
  BoneStep& step = bone_steps_[agent];
  const std::uint8_t wanted = state_.bone_level[agent];
  const bool by_steps = request_.frame_step > Ticks{} && is_shown(agent);
  step = by_steps ? next_step(step, wanted) : settled_at(wanted);
  return step;
}

PoseRequest& LevelOfDetail::update_also(std::uint32_t agent) {
  bone_steps_[agent] = settled_at(0);
  return updates_.emplace_back(PoseRequest{.agent = {agent}});
}

void LevelOfDetail::show_at_once(PoseRequest& update) {
  update.look_ahead = Ticks{};
  make_due(update.agent.number);
}

void LevelOfDetail::settle(double predicted_nanoseconds, std::optional<float> measured_error_pixels) {
  for (const PoseRequest& update : updates_) {
    shown_in_[update.agent.number] = update.palette != nullptr ? frame_ : never_shown;
  }
  if (request_.frame_step == Ticks{}) return;
  const bool by_error = request_.rules.rule == LodRule::budget;
  const LodRules& rules = request_.rules;
  const auto exempt = static_cast<double>(selection_.cost.reappeared);
  const double counted = predicted_nanoseconds - exempt;
  figures_ = {.tolerance_px = by_error ? controller_.tolerance_pixels() : 0.0F,
              .binding = BindingLimit::none,
              .predicted_ms = predicted_nanoseconds / nanoseconds_per_millisecond,
              .budget_held = !has_budget() || counted <= budget_nanoseconds(rules),
              .error_held = {},
              .cost = selection_.cost};
  if (!by_error) return;
  controller_.settle(rules, {.cost_by_tolerance = selection_.cost.by_tolerance,
                             .nanoseconds = counted,
                             .exempt_nanoseconds = exempt,
                             .measured_error_pixels = measured_error_pixels});
  figures_.binding = controller_.binding();
  if (measured_error_pixels && rules.error_pixels > 0.0F) {
    figures_.error_held = *measured_error_pixels <= rules.error_pixels;
  }
}

}  // namespace throng::anim
