#include "engine/crowd/error_meter.h"

#include <algorithm>

#include "engine/anim/kernel/palette/hierarchy.h"
#include "engine/base/run_jobs.h"

namespace throng {
namespace {

constexpr float not_measured = -1.0F;
constexpr std::size_t most_jobs = 8;  // each has room for a palette
// The cost of measuring one agent, in bones of a posed crowd: the exact pose comes from blocks and rows outside the
// caches, then every point is skinned twice and projected.
constexpr double cost_of_exact_bone = 2.0, cost_of_point = 1.5;
constexpr double frames_of_credit = 4.0;
// Agents a frame. Of a crowd that is cheap to pose, the meter still measures some, and the most until a ninety-ninth
// percentile is known.
constexpr std::size_t most_measured_of_few = 24, least_measured_of_few = 4;

}  // namespace

ErrorMeter::ErrorMeter(std::span<const ViewedCharacter> characters) {
  characters_.resize(characters.size());
  for (std::size_t i = 0; i < characters.size(); ++i) set_character(i, characters[i]);
}

void ErrorMeter::set_character(std::size_t character, const ViewedCharacter& viewed) {
  const anim::Character& baked = *viewed.character;
  MeasuredCharacter& measured = characters_[character];
  measured.points = baked.surface_points;
  measured.kept_entries = anim::entries_at_levels(baked.skeleton);
  measured.packing = anim::packing_frames(baked.skeleton);
  measured.entries = static_cast<std::size_t>(baked.skeleton.palette_count());
  measured.cost =
      cost_of_exact_bone * baked.skeleton.bone_count() + cost_of_point * static_cast<double>(measured.points.count());
  most_entries_ = std::max(most_entries_, measured.entries);
  blended_.resize(most_jobs * most_entries_);
}

void ErrorMeter::reset(std::size_t agents) {
  errors_.assign(agents, not_measured);
  sampling_ = ErrorSampling::off;
  watched_.reset(agents, 0, most_entries_);
  credit_ = 0;
  window_ = {};
  pose_window_ = {};
  figures_ = {};
  history_ = {};
}

void ErrorMeter::begin_frame(ErrorSampling sampling, std::span<const anim::VisibleAgent> visible,
                             const ShownPoses& shown) {
  if (sampling != sampling_) {
    sampling_ = sampling;
    if (sampling == ErrorSampling::off) figures_ = {}, history_ = {};
    const std::size_t most = sampling == ErrorSampling::all ? errors_.size() : WatchedAgents::few;
    const std::size_t watched = sampling == ErrorSampling::off ? 0 : std::min(most, errors_.size());
    watched_.reset(errors_.size(), watched, most_entries_);
    exact_palettes_ = anim::allocate_aligned(watched * anim::palette_stride(most_entries_, PaletteFormat::matrices));
    chosen_.reserve(watched);
    measured_.reserve(watched);
    exact_.reserve(watched);
    if (sampling == ErrorSampling::some) {
      window_.reserve(most_measured_of_few);
      pose_window_.reserve(most_measured_of_few);
    }
  }
  watched_.choose(visible, shown);
}

void ErrorMeter::take(WatchedAgent& watched) {
  const std::size_t stride = anim::palette_stride(most_entries_, PaletteFormat::matrices);
  chosen_.push_back(static_cast<std::uint32_t>(&watched - watched_.all().data()));
  std::byte* const palette = exact_palettes_.get() + exact_.size() * stride;
  exact_.push_back({.agent = {watched.agent}, .palette = reinterpret_cast<anim::PaletteMatrix*>(palette)});
}

double ErrorMeter::affordable_bones(const anim::UpdateReport& update) const {
  const std::size_t least = figures_.p99_is_known() ? least_measured_of_few : most_measured_of_few;
  return std::max(share_of_pose_cost * static_cast<double>(update.bones_evaluated),
                  static_cast<double>(least) * characters_.front().cost);
}

// An agent that was first measured in the frame before is measured again, which gives the change of its error; then
// other agents follow, as long as the update's cost affords it.
void ErrorMeter::choose_whom_to_measure(const anim::AnimationSystem& system, const MeasuredFrame& frame) {
  chosen_.clear();
  exact_.clear();
  const bool all = sampling_ == ErrorSampling::all;
  const double affordable = affordable_bones(system.figures().report());
  credit_ = std::min(credit_ + affordable, frames_of_credit * affordable + 2 * characters_.front().cost);
  const std::span<WatchedAgent> watched = watched_.all();
  const auto is_ready = [&](const WatchedAgent& each) {
    return each.can_be_measured() && system.agent(each.agent).can_pose_exactly();
  };
  for (WatchedAgent& each : watched) {
    const bool again = each.measured_in + 1 == frame.number && each.measured_again_in != each.measured_in;
    if (!(all || again) || !is_ready(each)) continue;
    if (again) each.measured_again_in = frame.number;
    take(each);
  }
  for (std::size_t i = 0; !all && i < watched.size() && chosen_.size() < most_measured_of_few; ++i) {
    next_place_ = (next_place_ + 1) % watched.size();
    WatchedAgent& each = watched[next_place_];
    if (each.measured_in + 1 == frame.number || !is_ready(each)) continue;
    const double cost = 2 * characters_[frame.agents.characters[each.agent]].cost;
    if (credit_ < cost) break;
    credit_ -= cost;
    take(each);
  }
}

// A person who changes a rule waits for the figures of that rule, not of the former one.
void ErrorMeter::forget_other_rules(const ViewRules& rules) {
  if (rules != measured_with_) window_.begin_anew();
  measured_with_ = rules;
}

void ErrorMeter::end_frame(anim::AnimationSystem& system, const MeasuredFrame& frame) {
  watched_.hand_over();
  if (sampling_ == ErrorSampling::off) return;
  forget_other_rules(frame.rules);
  window_.begin_frame();
  pose_window_.begin_frame();
  choose_whom_to_measure(system, frame);
  if (!exact_.empty()) system.pose_exactly(exact_);
  measure_chosen(system, frame);
  for (const Measured& measured : measured_) {
    pose_window_.add(measured.pose);
    window_.add(measured.picture);
  }
  figures_ = window_.figures();
  history_.add({.p99 = figures_.p99, .pop = window_.newest_pop()});
}

void ErrorMeter::measure_chosen(anim::AnimationSystem& system, const MeasuredFrame& frame) {
  measured_.resize(chosen_.size());
  const std::size_t jobs = std::min({chosen_.size(), static_cast<std::size_t>(system.options().pus), most_jobs});
  if (jobs == 0) return;
  run_jobs(system.executor(), jobs, [&](std::size_t job) {
    const std::span room = std::span(blended_).subspan(job * most_entries_, most_entries_);
    for (std::size_t i = job; i < chosen_.size(); i += jobs) {
      measured_[i] = measure(watched_.all()[chosen_[i]], exact_[i].palette, frame, room);
    }
  });
}

ErrorMeter::Measured ErrorMeter::measure(WatchedAgent& watched, const anim::PaletteMatrix* exact,
                                         const MeasuredFrame& frame, std::span<anim::PaletteMatrix> room) {
  const MeasuredCharacter& character = characters_[frame.agents.characters[watched.agent]];
  const ShownPose& pose = frame.shown.pose(watched.agent);
  const std::span blended = room.first(character.entries);
  const bool packed = watched.format == PaletteFormat::packed;
  anim::blend_shown_palette({.from = anim::PaletteDestination(watched.blends ? watched.from : watched.to),
                             .to = anim::PaletteDestination(watched.to),
                             .packing = packed ? character.packing : std::span<const anim::PackingFrame>(),
                             .blend = anim::blend_of(pose.from_time, pose.to_time - pose.from_time, frame.now),
                             .kept_entries = character.kept_entries[pose.level()],
                             .shown = blended});
  const anim::ModelOnScreen screen{
      .model_to_clip = frame.projection * (frame.view * frame.agents.model_to_world(watched.agent)),
      .half_size = frame.size * 0.5F};
  anim::SurfaceErrors errors;
  anim::measure_surface(character.points, blended, {exact, character.entries}, screen, errors);
  anim::ErrorSample sample{.error = errors.largest, .pop = {}};
  if (watched.measured_in + 1 == frame.number) sample.pop = anim::largest_change(watched.errors, errors);
  watched.errors = errors;
  watched.measured_in = frame.number;
  Measured measured{.pose = sample, .picture = sample};
  measured.picture.error += mesh_error(watched.agent, frame);
  errors_[watched.agent] = measured.picture.error;
  return measured;
}

float ErrorMeter::mesh_error(std::uint32_t agent, const MeasuredFrame& frame) {
  const auto found = std::ranges::lower_bound(frame.visible, agent, {}, &anim::VisibleAgent::agent);
  if (found == frame.visible.end() || found->agent != agent) return 0.0F;
  const std::uint8_t character = frame.agents.characters[agent];
  const std::uint8_t lod = frame.mesh_of_visible[static_cast<std::size_t>(found - frame.visible.begin())];
  return frame.mesh_lods.error_px(character, lod, found->pixels_tall);
}

}  // namespace throng
