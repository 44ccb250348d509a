#include "app/stage.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include <glm/geometric.hpp>

#include "app/agent_colors.h"

namespace throng::app {
namespace {

constexpr float push_impulse = 60.0F;      // kg m/s: a hard shove
constexpr double push_height = 0.75;       // of the character's, where it is met
constexpr float least_body_radius = 0.2F;  // metres, to click at

std::vector<std::uint32_t> entries_by_level(const anim::Skeleton& skeleton) {
  std::vector<std::uint32_t> entries;
  for (const int bones : skeleton.level_bone_counts) {
    entries.push_back(static_cast<std::uint32_t>(anim::palette_count_for_bones(skeleton, bones)));
  }
  return entries;
}

bool same_crowd(const Tuning& a, const Tuning& b) {
  return a.scene == b.scene && a.agents == b.agents && a.seed == b.seed;
}

std::string joined(std::span<const std::string> sentences) {
  std::string all;
  for (const std::string& sentence : sentences) all += (all.empty() ? "" : "; ") + sentence;
  return all;
}

std::uint32_t microseconds(anim::Ticks ticks) {
  return static_cast<std::uint32_t>(ticks * 10 / (anim::ticks_per_second / 100'000));
}

}  // namespace

anim::SystemOptions system_options(const Tuning& tuning) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return {.pus = tuning.pus == 0 ? cores : tuning.pus,
          .local_store_bytes = static_cast<std::size_t>(tuning.local_store_kib) * 1024,
          .tile = tuning.tile,
          .schedule = tuning.schedule == Schedule::fused ? anim::Schedule::fused : anim::Schedule::levels,
          .double_buffering = static_cast<anim::DoubleBuffering>(tuning.double_buffer),
          .stream = tuning.stream == Stream::sampled ? anim::StreamKind::sampled : anim::StreamKind::keyframe};
}

anim::LodRules lod_rules(const Tuning& tuning, int level_count) {
  return {
      .rule = tuning.lod == LodRule::off ? anim::LodRule::off : anim::LodRule::distance,
      .full_rate_distance = tuning.full_rate_distance,
      .interval_growth = tuning.interval_growth,
      .largest_interval = tuning.largest_interval,
      .bone_lod = tuning.bone_lod,
      .level_distances = {tuning.bone_level_distance[0], tuning.bone_level_distance[1], tuning.bone_level_distance[2]},
      .level_count = level_count};
}

Stage::Stage(CharacterSource character, render::PalettePageSource& pages)
    : character_(std::move(character)),
      slots_(pages, entries_by_level(character_.character->skeleton)),
      shown_(slots_) {}

anim::Result<std::unique_ptr<Stage>> Stage::create(CharacterSource character, const Tuning& tuning,
                                                   render::PalettePageSource& pages) {
  std::unique_ptr<Stage> stage(new Stage(std::move(character), pages));
  auto system = anim::AnimationSystem::create(stage->character_.character, system_options(tuning));
  if (!system) return system.error();
  stage->system_ = std::move(*system);
  stage->rigs_ = std::make_unique<const anim::CharacterRigs>(stage->character_.model);
  const anim::RigKinds kinds = stage->rigs_->add_to(*stage->system_);
  stage->fallen_ = std::make_unique<FallenAgents>(kinds.ragdoll, *stage->system_);
  stage->feet_ = std::make_unique<PlacedFeet>(kinds.foot_placement, *stage->system_);
  stage->tuning_ = tuning;
  stage->populate();
  return stage;
}

anim::Status Stage::apply(const Tuning& tuning) {
  const anim::SystemOptions options = system_options(tuning);
  if (options != system_->options()) {
    const anim::Status configured = system_->configure(options);
    if (!configured) return configured;
  }
  const bool keeps_crowd = same_crowd(tuning, tuning_);
  tuning_ = tuning;
  if (!moving_) lod_.make_all_due();  // nobody's turn comes while time stands still, but tuning shows at once
  if (!keeps_crowd) populate();
  return anim::Done{};
}

void Stage::set_roles(const RoleClips& clips) {
  assign_roles(character_, clips);
  if (!moving_) lod_.make_all_due();
  populate();
}

void Stage::populate() {
  const auto agents = static_cast<std::size_t>(tuning_.agents);
  crowd_ = std::make_unique<Crowd>(tuning_.scene, agents, tuning_.seed, character_.roles);
  selected_.reset();
  fallen_->reset();
  feet_->reset(agents);
  system_->set_agent_count(0);
  system_->set_agent_count(static_cast<std::uint32_t>(agents));
  played_speeds_.assign(agents, 0.0F);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    request_clip(agent, crowd_->clips()[agent], 0, static_cast<double>(crowd_->start_phases()[agent]));
  }
  lod_.resize(agents, selection_);
  shown_.reset(agents, frame_);
  updates_.reserve(agents);
}

void Stage::request_clip(std::uint32_t agent, int clip, anim::Ticks fade, double start_phase) {
  const int index = clip == no_clip ? 0 : clip;
  const anim::Ticks duration = character_.character->clips[static_cast<std::size_t>(index)].duration;
  const bool plays = clip != no_clip;
  played_speeds_[agent] = crowd_->playback_speeds()[agent];
  system_->play(agent, {.clip = index,
                        .fade = fade,
                        .speed = plays ? static_cast<double>(crowd_->playback_speeds()[agent]) : 0.0,
                        .start = plays ? static_cast<anim::Ticks>(start_phase * static_cast<double>(duration)) : 0});
}

void Stage::request_clip(const std::optional<ClipRequest>& request) {
  if (!request) return;
  request_clip(request->agent, request->clip, anim::to_ticks(static_cast<double>(request->fade_seconds)), 0.0);
}

void Stage::move(anim::Ticks delta) {
  moving_ = delta > 0;
  if (moving_) ++frames_moved_;
  system_->advance(delta);
  const auto requests = crowd_->advance(delta, system_->executor(), system_->options().pus);
  for (const ClipRequest& request : requests) request_clip(request);
  match_playback();
}

// Those who walk go at their own pace from frame to frame, and their feet with them.
void Stage::match_playback() {
  const std::span<const float> speeds = crowd_->playback_speeds();
  const std::size_t movers = crowd_->walkers() + crowd_->marchers();
  for (std::uint32_t agent = 0; agent < movers; ++agent) {
    if (speeds[agent] == played_speeds_[agent] || crowd_->clips()[agent] == no_clip) continue;
    system_->set_speed(agent, static_cast<double>(speeds[agent]));
    played_speeds_[agent] = speeds[agent];
  }
}

std::uint32_t Stage::now() const { return microseconds(system_->clock()); }

anim::LodFrame Stage::lod_frame(const render::Camera& camera, int width, int height) const {
  const render::CameraView view = render::view_of(camera, static_cast<float>(width) / static_cast<float>(height));
  const anim::Character& character = *character_.character;
  return {.positions = crowd_->positions(),
          .scales = crowd_->scales(),
          .bounds = {.centre_height = static_cast<float>(character_.bounds.height / 2.0),
                     .radius = static_cast<float>(character_.bounds.reach),
                     .height = static_cast<float>(character_.bounds.height)},
          .camera = {.position = camera.position,
                     .frustum = render::frustum_planes(view),
                     .pixels_per_unit = render::pixels_tall(camera, static_cast<float>(height), 1.0F, 1.0F)},
          .rules = lod_rules(tuning_, static_cast<int>(character.skeleton.level_bone_counts.size())),
          .number = frames_moved_};
}

void Stage::pose(const render::Camera& camera, int width, int height, anim::Ticks frame_step,
                 std::uint64_t completed_frame) {
  const std::uint64_t last_frame = frame_++;
  slots_.reclaim(completed_frame);
  anim::select_for_update(lod_frame(camera, width, height), lod_, selection_);
  shown_.hide_unseen(selection_.visible, last_frame);
  updates_.clear();
  auto seen = selection_.visible.begin();
  for (const anim::DueAgent& due : selection_.due) {
    while (seen != selection_.visible.end() && seen->agent < due.agent) ++seen;
    if (crowd_->holds(due.agent)) continue;  // it has fallen
    const bool visible = seen != selection_.visible.end() && seen->agent == due.agent;
    // Smooth skipping: the pose of the moment when it will have been reached. Evaluated each frame, it is that of now.
    const bool ahead = tuning_.smooth && due.look_ahead > 1 && shown_.pose(due.agent).shown();
    const anim::Ticks look_ahead = ahead ? due.look_ahead * frame_step : 0;
    updates_.push_back({.agent = due.agent, .level = due.bone_level, .look_ahead = look_ahead, .palette = nullptr});
    place_feet(due, visible && !ahead);
    if (!visible) continue;
    updates_.back().palette =
        shown_.show(due.agent, due.bone_level, now(), microseconds(system_->clock() + look_ahead), last_frame);
  }
  pose_fallen(last_frame);
  system_->update(updates_);
  get_up();
}

// Whoever is evaluated now and not ahead, so that it is known where the feet are; without level of detail, everyone.
void Stage::place_feet(const anim::DueAgent& due, bool near_by) {
  const bool everyone = tuning_.lod == LodRule::off;
  if (tuning_.placed_feet && due.bone_level == 0 && (everyone || (near_by && due.look_ahead <= 1))) {
    feet_->place(*crowd_, due.agent);
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
    updates_.push_back({.agent = fallen.agent, .level = 0, .look_ahead = 0, .palette = nullptr});
    if (visible) updates_.back().palette = shown_.show(fallen.agent, 0, now(), now(), last_frame);
  }
}

void Stage::get_up() {
  for (const std::uint32_t agent : fallen_->advance()) request_clip(crowd_->release(agent));
}

anim::Status Stage::push_over(std::uint32_t agent, const glm::vec3& direction) {
  if (!can_fall()) return anim::Error{"nobody can be pushed over: " + joined(rigs_->missing())};
  const Heading heading = crowd_->headings()[agent];
  const glm::vec2 way(heading.cosine * direction.x - heading.sine * direction.z,
                      heading.sine * direction.x + heading.cosine * direction.z);
  const glm::vec2 impulse = way * (push_impulse / std::max(glm::length(way), 1e-3F));
  const bool stood = !crowd_->holds(agent);
  if (stood) request_clip(crowd_->hold(agent));
  const auto chest = static_cast<float>(push_height * character_.bounds.height);
  const anim::Status pushed = fallen_->push(agent, {impulse.x, 0.0F, impulse.y}, {0.0F, chest, 0.0F});
  if (!pushed && stood) request_clip(crowd_->release(agent));
  return pushed;
}

// Somebody who lies is as long as they were tall, in any direction.
UprightBody Stage::body_of(std::uint32_t agent) const {
  const float scale = crowd_->scales()[agent];
  const float height = static_cast<float>(character_.bounds.height) * scale;
  const float radius = std::max(static_cast<float>(character_.bounds.body_radius), least_body_radius) * scale;
  UprightBody body{.agent = agent, .foot = crowd_->positions()[agent], .radius = radius, .height = height};
  const std::optional<glm::vec3> hips = fallen_->hips(agent);
  if (!hips || hips->y * scale > height / 4.0F) return body;
  const Heading heading = crowd_->headings()[agent];
  const glm::vec2 aside(heading.cosine * hips->x + heading.sine * hips->z,
                        heading.cosine * hips->z - heading.sine * hips->x);
  body.foot += scale * glm::vec3(aside.x, 0.0F, aside.y);
  body.radius = height / 2.0F;
  body.height = height / 4.0F;
  return body;
}

std::vector<UprightBody> Stage::bodies_in_view() const {
  std::vector<UprightBody> bodies;
  bodies.reserve(selection_.visible.size());
  for (const anim::VisibleAgent& agent : selection_.visible) bodies.push_back(body_of(agent.agent));
  return bodies;
}

bool Stage::record(const anim::VisibleAgent& agent, render::InstanceRecord& record) const {
  const ShownPose& pose = shown_.pose(agent.agent);
  if (!pose.shown()) return false;
  const glm::vec3 position = crowd_->positions()[agent.agent];
  const Heading heading = crowd_->headings()[agent.agent];
  record = {
      .position = {position.x, position.y, position.z},
      .scale = crowd_->scales()[agent.agent],
      .heading_cosine = heading.cosine,
      .heading_sine = heading.sine,
      .palette_from = pose.from.first_entry,
      .palette_to = pose.to.first_entry,
      .blend_start = pose.from_time,
      .blend_duration = pose.to_time - pose.from_time,
      .agent = agent.agent,
      .debug_color = agent.agent == selected_ ? selected_color : debug_color(tuning_.debug_view, agent, pose.level()),
      .tints = {},
      .bone_level = pose.level(),
      .shape = crowd_->variants()[agent.agent].shape(),
      .hair = crowd_->variants()[agent.agent].hair()};
  std::ranges::copy(crowd_->tints()[agent.agent], record.tints);
  return true;
}

}  // namespace throng::app
