// What happens on a stage in a frame: move, then pose, then say what to draw.
#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "app/settings/agent_colors.h"
#include "app/stage/stage.h"

namespace throng::app {
namespace {

// A thing in the air has no spot below it.
float contact_scale(const CharacterSource& source) {
  return source.roles.is_prop ? 0.0F : static_cast<float>(source.roles.size());
}

constexpr float longest_shadow = 14.0F;  // metres, of a person; what is cast farther is faint

/// Moves the planes of a frustum outwards, as far as the shadow of somebody outside may fall in. A frustum holds a ball
/// that moves along the light if it holds the ball at either end.
std::array<glm::vec4, 6> with_casters(std::array<glm::vec4, 6> planes, const glm::vec3& to_light, float height) {
  const float length = std::min(height / std::max(to_light.y, 1e-3F), longest_shadow / 1.8F * height);
  for (glm::vec4& plane : planes) plane.w += length * std::max(-glm::dot(glm::vec3(plane), to_light), 0.0F);
  return planes;
}

float tallest_of(std::span<const CharacterSource> characters) {
  double height = 0.0;
  for (const CharacterSource& source : characters) height = std::max(height, source.character->bounds.height);
  return static_cast<float>(height);
}

constexpr std::size_t least_agents_to_learn_from = 100;
constexpr std::size_t agents_ahead = 12;  // that the caches are asked for while one is shown

// Colours of errors are for everybody in view.
ErrorSampling error_sampling(const Tuning& tuning) {
  return tuning.debug_view == DebugView::error ? ErrorSampling::all : tuning.error_sample;
}

anim::LodForce lod_force(const LodInspection& inspection, std::optional<std::uint32_t> selected) {
  if (inspection.force_selected_only && !selected) return {};
  return {.interval = inspection.forced_interval,
          .bone_level = inspection.forced_bone_level,
          .agent = inspection.force_selected_only ? selected : std::nullopt};
}

/// Tells the milliseconds since it was asked last, or made.
class StopWatch {
 public:
  double lap() {
    const auto before = std::exchange(since_, std::chrono::steady_clock::now());
    return std::chrono::duration<double, std::milli>(since_ - before).count();
  }

 private:
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

std::uint32_t microseconds(anim::Ticks ticks) {
  return static_cast<std::uint32_t>(ticks * 10 / (anim::ticks_per_second / 100'000));
}

}  // namespace

void Stage::move(anim::Ticks delta) {
  StopWatch watch;
  moving_ = delta > anim::Ticks{};
  const FollowedTracks* const tracks = crowd().tracks();
  const double seconds = tracks != nullptr ? tracks->clock().seconds : 0.0;
  animated_->move(delta);
  if (tracks != nullptr) {
    track_clock_ = tracks->clock();
    if ((track_clock_->seconds - seconds) * track_clock_->rate < 0.0) jump();  // the part begins anew
  }
  times_.crowd_ms = watch.lap();
}

std::uint32_t Stage::now() const { return microseconds(system().clock()); }

std::array<glm::vec4, 6> Stage::seen_by(const render::Camera& camera, const glm::vec2& size) const {
  const auto planes = render::frustum_planes(render::view_of(camera, size.x / size.y));
  if (!tuning_.shadows || !render::casts_shadows(tuning_.light)) return planes;
  return with_casters(planes, render::to_brightest(tuning_.light), tallest_of(characters_));
}

anim::LodRequest Stage::lod_request(const render::Camera& camera, const glm::vec2& size, anim::Ticks frame_step) const {
  return {.camera = {.position = camera.position,
                     .frustum = seen_by(camera, size),
                     .pixels_per_unit = render::pixels_tall(camera, size.y, 1.0F, 1.0F),
                     .forward = render::forward(camera)},
          .rules = tuning_.lod,
          .limits = limits(),
          .force = lod_force(tuning_.inspection, selected_),
          .selected = selected_,
          .now = system().clock(),
          .frame_step = moving_ ? frame_step : anim::Ticks{}};
}

void Stage::pose(const render::Camera& camera, int width, int height, anim::Ticks frame_step,
                 std::uint64_t completed_frame) {
  StopWatch watch;
  const glm::vec2 size(static_cast<float>(width), static_cast<float>(height));
  const std::uint64_t last_frame = frame_++;
  exact_.give_back(last_frame);
  slots_.reclaim(completed_frame);
  lod_.select({.positions = crowd().positions(),
               .scales = crowd().scales(),
               .character_of = crowd().characters(),
               .clips = crowd().minds().clips(),
               .left_out = animated_->fallen().left_out(),
               .absent = absent_of(crowd())},
              lod_request(camera, size, frame_step), animated_->system().executor(), system().options().pus);
  mesh_choice_.choose(selection().visible, crowd().characters(), mesh_lods_, tuning_, animated_->system().executor(),
                      system().options().pus);
  times_.selection_ms = watch.lap();
  measures_.take(crowd(), tuning_, animated_->system().executor(), system().options().pus);
  shown_.hide_unseen(lod_, last_frame, animated_->system().executor(), system().options().pus);
  joints_.make_room(crowd().size());
  meter_.begin_frame(error_sampling(tuning_), selection().visible, shown_);
  const std::span<anim::AgentUpdate> updates = lod_.updates();
  for (std::size_t i = 0; i < updates.size(); ++i) {
    if (i + agents_ahead < updates.size()) shown_.prefetch_pose(updates[i + agents_ahead].agent.number);
    anim::AgentUpdate& update = updates[i];
    const std::uint32_t agent = update.agent.number;
    const bool visible = lod_.is_visible(agent);
    const bool ahead = update.look_ahead > anim::Ticks{};
    animated_->details().follow_track(updates.subspan(i));
    place_feet(update, visible && !ahead);
    if (!visible) continue;
    show(update, last_frame);
    const bool on_a_new_page = shown_.pose(agent).to_time == now();
    if (!ahead || !on_a_new_page) continue;
    lod_.show_at_once(update);
    animated_->details().follow_track(updates.subspan(i, 1));  // for the pose of now
  }
  if (tuning_.lod.rule != anim::LodRule::off) animated_->details().take_back(selection().visible);
  animated_->details().hold_things(selection().visible);
  pose_fallen(last_frame);
  animated_->system().update(lod_.updates());
  measure(camera, size);
  const anim::ErrorFigures error = meter_.pose_figures();
  // In the first frames nobody is skipped yet, so errors are too small to learn from. Of few agents, one alone is more
  // than the hundredth part, and calm ones say nothing of what it does next.
  const bool tells = error.p99_is_known() && error.frames >= anim::ErrorWindow::frames &&
                     selection().visible.size() >= least_agents_to_learn_from;
  lod_.settle(system().figures().report().predicted_nanoseconds, tells ? std::optional(error.p99) : std::nullopt);
  animated_->let_fallen_get_up();
  times_.pose_ms = watch.lap();
}

void Stage::pose_exactly() {
  exact_.give_back(frame_);
  for (const anim::VisibleAgent& each : selection().visible) {
    const ShownPose& shown = shown_.pose(each.agent);
    const bool known = shown.shown() && system().agent(each.agent).can_pose_exactly();
    exact_.add(each.agent, shown, known ? character_of(each.agent).character->level_entries.front() : 0);
  }
  exact_.pose(animated_->system());
}

void Stage::measure(const render::Camera& camera, const glm::vec2& size) {
  meter_.end_frame(animated_->system(), {.tuning = tuning_,
                                         .crowd = crowd(),
                                         .visible = selection().visible,
                                         .mesh_lods = mesh_lods_,
                                         .mesh_of_visible = mesh_choice_.lods(),
                                         .shown = shown_,
                                         .view = render::view_of(camera, size.x / size.y),
                                         .size = size,
                                         .now = now(),
                                         .number = frame_});
}

void Stage::show(anim::AgentUpdate& update, std::uint64_t last_frame) {
  const std::uint32_t agent = update.agent.number;
  const std::uint8_t character = crowd().characters()[agent];
  const NewPose pose{.agent = agent,
                     .level = update.level,
                     .entries = characters_[character].character->level_entries[update.level],
                     .time = microseconds(system().clock() + update.look_ahead),
                     .format = system().characters().palette_format(character)};
  const anim::PaletteDestination memory = shown_.show(pose, now(), last_frame);
  update.palette = meter_.destination(agent, shown_.pose(agent), pose.entries, memory);
  update.joints = joints_.destination(agent);
}

// Feet are placed for agents that are evaluated each frame and not ahead, so that it is known where the feet are;
// without level of detail, for all.
void Stage::place_feet(const anim::AgentUpdate& update, bool near_by) {
  const bool everyone = tuning_.lod.rule == anim::LodRule::off;
  const anim::LodChoice choice = lod_.choice(update.agent.number);
  const bool stand = tuning_.placed_feet && choice.bone_level == 0 && (everyone || (near_by && choice.interval == 1));
  animated_->details().place_feet(update.agent.number, stand, shown_.pose(update.agent.number).shown());
}

// Rag-dolls have no pose that could be looked ahead to, and fall on where nobody sees them.
void Stage::pose_fallen(std::uint64_t last_frame) {
  for (const FallenAgents::Fallen& fallen : animated_->fallen().fallen()) {
    const ShownPose& pose = shown_.pose(fallen.agent);
    const bool looked_ahead = pose.shown() && static_cast<std::int32_t>(pose.to_time - now()) > 0;
    if (looked_ahead || (!moving_ && pose.shown())) continue;
    anim::AgentUpdate& update = lod_.update_also(fallen.agent);
    if (lod_.is_visible(fallen.agent)) show(update, last_frame);
  }
}

bool Stage::record(const anim::VisibleAgent& agent, render::InstanceRecord& record, Poses poses) const {
  const ShownPose& pose = pose_of(agent.agent, poses);
  if (!pose.shown()) return false;
  const glm::vec3 position = crowd().positions()[agent.agent];
  const Heading heading = crowd().headings()[agent.agent];
  record = {.position = {position.x, position.y, position.z},
            .scale = crowd().scales()[agent.agent],
            .heading_cosine = heading.cosine,
            .heading_sine = heading.sine,
            .palette_from = pose.from_word(),
            .palette_to = pose.to_word(),
            .blend_start = pose.from_time,
            .blend_duration = pose.to_time - pose.from_time,
            .agent = agent.agent,
            .debug_color = agent.agent == selected_ ? selected_color
                                                    : debug_color(tuning_, {.interval = agent.interval,
                                                                            .bone_level = pose.level(),
                                                                            .error_px = meter_.error_of(agent.agent),
                                                                            .measure = measures_.of(agent.agent)}),
            .bone_level = pose.level(),
            .weights = 0,
            .contact_scale = contact_scale(character_of(agent.agent))};
  return true;
}

}  // namespace throng::app
