// What happens on a stage in a frame: move, then pose, then say what to draw.
#include <algorithm>

#include "app/settings/agent_colors.h"
#include "app/stage/stage.h"

namespace throng::app {
namespace {

// A thing in the air has no spot below it.
float contact_scale(const CharacterSource& source) {
  return source.roles.is_prop ? 0.0F : static_cast<float>(source.roles.size());
}

// Colours of errors are for everybody in view.
ErrorSampling error_sampling(const Tuning& tuning) {
  return tuning.debug_view == DebugView::error ? ErrorSampling::all : tuning.error_sample;
}

std::uint32_t microseconds(anim::Ticks ticks) {
  return static_cast<std::uint32_t>(ticks * 10 / (anim::ticks_per_second / 100'000));
}

}  // namespace

void Stage::move(anim::Ticks delta) {
  moving_ = delta > 0;
  if (moving_) ++frames_moved_;
  const anim::Ticks before = system_->clock();
  system_->advance(delta);
  if (event_sums_) event_sums_->add_events(*system_, before);
  const auto requests = crowd_->advance(delta, system_->executor(), system_->options().pus);
  if (event_sums_) event_sums_->add_places(*crowd_);
  for (const ClipRequest& request : requests) request_clip(request);
  match_playback();
  if (cut_scene_ && moving_) cut_scene_->advance();
}

// Those who walk go at their own pace from frame to frame, and their feet with them.
void Stage::match_playback() {
  const std::span<const float> speeds = crowd_->playback_speeds();
  const std::size_t movers = crowd_->walkers() + crowd_->marchers();
  for (std::uint32_t agent = 0; agent < movers; ++agent) {
    if (speeds[agent] == played_speeds_[agent] || crowd_->clips()[agent] == no_clip || holds_clip(agent)) continue;
    system_->agent(agent).set_speed(static_cast<double>(speeds[agent]));
    played_speeds_[agent] = speeds[agent];
  }
}

anim::LodForce Stage::lod_force(const LodInspection& inspection) const {
  if (inspection.force_selected_only && !selected_) return {};
  return {.interval = inspection.forced_interval,
          .bone_level = inspection.forced_bone_level,
          .agent = inspection.force_selected_only ? selected_ : std::nullopt};
}

std::uint32_t Stage::now() const { return microseconds(system_->clock()); }

anim::LodFrame Stage::lod_frame(const render::Camera& camera, int width, int height) {
  const render::CameraView view = render::view_of(camera, static_cast<float>(width) / static_cast<float>(height));
  return {.positions = crowd_->positions(),
          .scales = crowd_->scales(),
          .characters = lod_characters_,
          .character_of = crowd_->characters(),
          .clips = crowd_->clips(),
          .importance = crowd_lod_.importance(),
          .changing = crowd_lod_.changing(),
          .choices = &crowd_lod_.choices(),
          .camera = {.position = camera.position,
                     .frustum = render::frustum_planes(view),
                     .pixels_per_unit = render::pixels_tall(camera, static_cast<float>(height), 1.0F, 1.0F),
                     .forward = render::forward(camera)},
          .rules = crowd_lod_.rules(),
          .force = lod_force(tuning_.inspection),
          .number = frames_moved_};
}

void Stage::pose(const render::Camera& camera, int width, int height, anim::Ticks frame_step,
                 std::uint64_t completed_frame) {
  const std::uint64_t last_frame = frame_++;
  exact_.give_back(last_frame);
  slots_.reclaim(completed_frame);
  crowd_lod_.prepare({.rules = tuning_.lod, .now = system_->clock(), .frame_step = frame_step}, selected_);
  const auto select = [&] {
    anim::select_for_update(lod_frame(camera, width, height), lod_, selection_, system_->executor(),
                            system_->options().pus);
  };
  select();
  if (crowd_lod_.begin(tuning_, selection_.cost)) {
    lod_.make_all_due();
    select();
  }
  shown_.hide_unseen(selection_.visible, last_frame);
  meter_.begin_frame(error_sampling(tuning_), selection_.visible, shown_);
  updates_.clear();
  auto seen = selection_.visible.begin();
  for (const anim::DueAgent& due : selection_.due) {
    while (seen != selection_.visible.end() && seen->agent < due.agent) ++seen;
    if (crowd_->holds(due.agent) && !holds_clip(due.agent)) continue;  // it has fallen
    const bool visible = seen != selection_.visible.end() && seen->agent == due.agent;
    // Smooth skipping: the pose of the moment when it will have been reached. Evaluated each frame, it is that of now.
    const bool ahead = tuning_.lod.smooth && due.look_ahead > 1 && shown_.pose(due.agent).shown();
    const anim::Ticks look_ahead = ahead ? due.look_ahead * frame_step : 0;
    const BoneStep bones = step_bones(due);
    updates_.push_back({.agent = due.agent,
                        .level = bones.level,
                        .look_ahead = look_ahead,
                        .palette = nullptr,
                        .fade_level = bones.fade_level,
                        .fade_halves = bones.fade_halves});
    place_feet(due, visible && !ahead);
    if (!visible) continue;
    updates_.back().palette = show(due.agent, bones.level, microseconds(system_->clock() + look_ahead), last_frame);
    if (!ahead || shown_.pose(due.agent).to_time != now()) continue;
    updates_.back().look_ahead = 0;  // nothing to blend from on its new page
    lod_.make_due(due.agent);
  }
  if (tuning_.lod.rule != anim::LodRule::off) feet_->take_back(selection_.visible);
  pose_fallen(last_frame);
  system_->update(updates_);
  measure(camera, width, height);
  crowd_lod_.settle(tuning_, selection_.cost, system_->figures().report().predicted_nanoseconds, moving_);
  get_up();
}

void Stage::pose_exactly() {
  exact_.give_back(frame_);
  for (const anim::VisibleAgent& each : selection_.visible) {
    const ShownPose& shown = shown_.pose(each.agent);
    const bool known = shown.shown() && system_->agent(each.agent).can_pose_exactly();
    exact_.add(each.agent, shown, known ? palette_entries_[crowd_->characters()[each.agent]].front() : 0);
  }
  exact_.pose(*system_);
}

void Stage::measure(const render::Camera& camera, int width, int height) {
  const glm::vec2 size(static_cast<float>(width), static_cast<float>(height));
  meter_.end_frame(*system_, {.crowd = *crowd_,
                              .shown = shown_,
                              .view = render::view_of(camera, size.x / size.y),
                              .size = size,
                              .now = now(),
                              .number = frame_});
  const anim::ErrorFigures& error = meter_.figures();
  crowd_lod_.tell_measured_error(error.p99_is_known() ? std::optional(error.p99) : std::nullopt);
}

// Whoever is shown goes from level to level by steps; who is not, and everybody while time stands still, at once.
BoneStep Stage::step_bones(const anim::DueAgent& due) {
  BoneStep& step = bone_steps_[due.agent];
  const bool watched = moving_ && shown_.pose(due.agent).shown();
  step = watched ? next_step(step, due.bone_level) : settled_at(due.bone_level);
  return step;
}

anim::PaletteDestination Stage::show(std::uint32_t agent, std::uint8_t level, std::uint32_t pose_time,
                                     std::uint64_t last_frame) {
  const std::uint8_t character = crowd_->characters()[agent];
  const NewPose pose{.agent = agent,
                     .level = level,
                     .entries = palette_entries_[character][level],
                     .time = pose_time,
                     .format = system_->characters().palette_format(character)};
  const anim::PaletteDestination memory = shown_.show(pose, now(), last_frame);
  return meter_.destination(agent, shown_.pose(agent), pose.entries, memory);
}

// Whoever is evaluated each frame and not ahead, so that it is known where the feet are; without level of detail,
// everyone.
void Stage::place_feet(const anim::DueAgent& due, bool near_by) {
  const bool everyone = tuning_.lod.rule == anim::LodRule::off;
  if (tuning_.placed_feet && due.bone_level == 0 && (everyone || (near_by && lod_.interval[due.agent] == 1))) {
    feet_->place(*crowd_, due.agent, shown_.pose(due.agent).shown());
  } else {
    feet_->let_go(due.agent);
  }
}

// Rag-dolls have no pose that could be looked ahead to, and fall on where nobody sees them.
void Stage::pose_fallen(std::uint64_t last_frame) {
  for (const FallenAgents::Fallen& fallen : fallen_->fallen()) {
    const ShownPose& pose = shown_.pose(fallen.agent);
    const bool looked_ahead = pose.shown() && static_cast<std::int32_t>(pose.to_time - now()) > 0;
    if (looked_ahead || (!moving_ && pose.shown())) continue;
    const bool visible = std::ranges::binary_search(selection_.visible, fallen.agent, {}, &anim::VisibleAgent::agent);
    bone_steps_[fallen.agent] = settled_at(0);
    updates_.push_back({.agent = fallen.agent, .level = 0, .look_ahead = 0, .palette = nullptr});
    if (visible) updates_.back().palette = show(fallen.agent, 0, now(), last_frame);
  }
}

void Stage::get_up() {
  for (const std::uint32_t agent : fallen_->advance()) request_clip(crowd_->release(agent));
}

bool Stage::record(const anim::VisibleAgent& agent, render::InstanceRecord& record, Poses poses) const {
  const ShownPose& pose = pose_of(agent.agent, poses);
  if (!pose.shown()) return false;
  const glm::vec3 position = crowd_->positions()[agent.agent];
  const Heading heading = crowd_->headings()[agent.agent];
  record = {.position = {position.x, position.y, position.z},
            .scale = crowd_->scales()[agent.agent],
            .heading_cosine = heading.cosine,
            .heading_sine = heading.sine,
            .palette_from = pose.from_word(),
            .palette_to = pose.to_word(),
            .blend_start = pose.from_time,
            .blend_duration = pose.to_time - pose.from_time,
            .agent = agent.agent,
            .debug_color = agent.agent == selected_
                               ? selected_color
                               : debug_color(tuning_.debug_view, {.interval = agent.interval,
                                                                  .bone_level = pose.level(),
                                                                  .error_px = meter_.error_of(agent.agent)}),
            .tints = {},
            .bone_level = pose.level(),
            .shape = crowd_->variants()[agent.agent].shape(),
            .hair = crowd_->variants()[agent.agent].hair(),
            .contact_scale = contact_scale(character_of(agent.agent))};
  std::ranges::copy(crowd_->tints()[agent.agent], record.tints);
  return true;
}

}  // namespace throng::app
