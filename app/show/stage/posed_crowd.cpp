#include "app/show/stage/posed_crowd.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

namespace throng::app {
namespace {

constexpr double nanoseconds_a_millisecond = 1e6;
constexpr auto cost_of_placed_feet =
    static_cast<std::uint32_t>(anim::foot_placement_work * anim::CostModel{}.post_process);

std::vector<std::size_t> palette_sizes(std::span<const CharacterSource> characters) {
  std::vector<std::size_t> sizes;
  for (const CharacterSource& source : characters) {
    for (const std::uint32_t entries : source.character->level_entries) {
      sizes.push_back(anim::palette_stride(entries, anim::PaletteFormat::matrices));
      sizes.push_back(anim::palette_stride(entries, anim::PaletteFormat::packed));
    }
  }
  return sizes;
}

constexpr float longest_shadow = 14.0F;  // metres, of a person; a shadow that falls farther is faint

/// Moves the planes of a frustum outwards, as far as the shadow of an agent outside may fall in. A frustum holds a ball
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

// The view of errors colours all agents in view.
ErrorSampling error_sampling(const Tuning& tuning) {
  return tuning.debug_view == DebugView::error ? ErrorSampling::all : tuning.error_sample;
}

anim::LodForce lod_force(const LodInspection& inspection, std::optional<std::uint32_t> selected) {
  if (inspection.force_selected_only && !selected) return {};
  return {.interval = inspection.forced_interval,
          .bone_level = inspection.forced_bone_level,
          .agent = inspection.force_selected_only ? selected : std::nullopt};
}

anim::LodLimits limits_of(const Tuning& tuning) {
  return {.error_pixels = pose_error_limit(tuning),
          .budget_nanoseconds = static_cast<double>(tuning.budget_ms) * nanoseconds_a_millisecond};
}

}  // namespace

/// The input that all steps of a frame read.
struct PosedCrowd::Frame {
  AnimatedCrowd& animated;
  const SeenFrame& seen;
  const Tuning& tuning;
  std::uint64_t last;  ///< the frame that was drawn last
  std::uint32_t now;   ///< of the shader's clock
  const Crowd& crowd = std::as_const(animated).crowd();
  anim::AnimationSystem& system = animated.system();
  int pus = system.options().pus;
};

std::uint32_t shader_time(Ticks clock) { return static_cast<std::uint32_t>(clock * 10 / (ticks_per_second / 100'000)); }

anim::LodCharacter lod_character(const CharacterSource& source) {
  anim::LodCharacter character = anim::lod_character(*source.character);
  if (!source.roles.is_prop) character.full_rate_nanoseconds = cost_of_placed_feet;
  return character;
}

PosedCrowd::PosedCrowd(std::span<const CharacterSource> characters, render::PalettePageSource& pages,
                       std::uint64_t first_frame)
    : characters_(characters),
      slots_(pages, palette_sizes(characters)),
      shown_(slots_),
      exact_(slots_),
      meter_(characters),
      mesh_lods_(characters.size()),
      frame_(first_frame) {
  learn_level_of_detail();
}

void PosedCrowd::learn_level_of_detail() {
  std::vector<anim::LodCharacter> characters;
  for (const CharacterSource& source : characters_) characters.push_back(lod_character(source));
  lod_.set_characters(std::move(characters));
}

void PosedCrowd::restart() {
  meter_ = ErrorMeter(characters_);
  lod_.restart();
}

void PosedCrowd::reset(std::size_t agents, const Tuning& tuning) {
  exact_.reset(agents, frame_);
  forget_shown(agents, tuning);
}

void PosedCrowd::forget_shown(std::size_t agents, const Tuning& tuning) {
  lod_.reset(agents, limits_of(tuning));
  mesh_choice_.reset(agents);
  shown_.reset(agents, frame_);
  meter_.reset(agents);
}

// Slots keep their sizes: a pose goes to the next larger one.
void PosedCrowd::take_character(std::size_t character, std::size_t agents) {
  learn_level_of_detail();
  meter_.set_character(character, characters_[character]);
  meter_.reset(agents);
  shown_.reset(agents, frame_);
  lod_.forget_shown();
  lod_.make_all_due();
}

void PosedCrowd::pose(AnimatedCrowd& animated, const SeenFrame& seen, const Tuning& tuning, StageTimes& times) {
  StopWatch watch;
  const Frame frame{animated, seen, tuning, frame_++, shader_time(animated.system().clock())};
  exact_.give_back(frame.last);
  slots_.reclaim(seen.completed);
  choose(frame);
  times.selection_ms = watch.lap();

  const std::span<const anim::VisibleAgent> visible = selection().visible;
  measures_.take(frame.crowd, tuning, frame.system.executor(), frame.pus);
  shown_.hide_unseen(lod_, frame.last, frame.system.executor(), frame.pus);
  joints_.make_room(frame.crowd.size());
  meter_.begin_frame(error_sampling(tuning), visible, shown_);
  prepare(frame, lod_.updates());
  if (tuning.lod.rule != anim::LodRule::off) animated.details().take_back(visible);
  animated.details().hold_things(visible);
  add_fallen(frame);
  frame.system.update(lod_.updates());
  measure(frame);
  settle(frame);
  animated.let_fallen_get_up();
  times.pose_ms = watch.lap();
}

std::array<glm::vec4, 6> PosedCrowd::seen_by(const Frame& frame) const {
  const auto planes = render::frustum_planes(render::view_of(frame.seen.camera, frame.seen.size.x / frame.seen.size.y));
  if (!frame.tuning.shadows || !render::casts_shadows(frame.tuning.light)) return planes;
  return with_casters(planes, render::to_brightest(frame.tuning.light), tallest_of(characters_));
}

anim::LodRequest PosedCrowd::lod_request(const Frame& frame) const {
  const render::Camera& camera = frame.seen.camera;
  return {.camera = {.position = camera.position,
                     .frustum = seen_by(frame),
                     .pixels_per_unit = render::pixels_tall(camera, frame.seen.size.y, 1.0F, 1.0F),
                     .forward = render::forward(camera)},
          .rules = frame.tuning.lod,
          .limits = limits_of(frame.tuning),
          .force = lod_force(frame.tuning.inspection, frame.seen.selected),
          .selected = frame.seen.selected,
          .now = frame.system.clock(),
          .frame_step = frame.seen.moves ? frame.seen.step : Ticks{}};
}

/// Finds the agents in view and their meshes, and lists the agents to be posed in lod_.updates().
void PosedCrowd::choose(const Frame& frame) {
  const Crowd& crowd = frame.crowd;
  lod_.select({.positions = crowd.positions(),
               .scales = crowd.scales(),
               .character_of = crowd.characters(),
               .clips = crowd.minds().clips(),
               .left_out = frame.animated.fallen().left_out(),
               .absent = absent_of(crowd)},
              lod_request(frame), frame.system.executor(), frame.pus);
  mesh_choice_.choose(selection().visible, crowd.characters(), mesh_lods_, frame.tuning, frame.system.executor(),
                      frame.pus);
}

/// Sets the parts of poses beyond clips, and where palettes go.
void PosedCrowd::prepare(const Frame& frame, std::span<anim::AgentUpdate> updates) {
  BodyDetails& details = frame.animated.details();
  for (std::size_t i = 0; i < updates.size(); ++i) {
    if (i + agents_ahead < updates.size()) shown_.prefetch_pose(updates[i + agents_ahead].agent.number);
    anim::AgentUpdate& update = updates[i];
    const std::uint32_t agent = update.agent.number;
    const bool visible = lod_.is_visible(agent);
    const bool ahead = update.look_ahead > Ticks{};
    details.follow_track(updates.subspan(i));
    place_feet(frame, update, visible && !ahead);
    if (!visible) continue;
    show(frame, update);
    const bool on_a_new_page = shown_.pose(agent).to_time == frame.now;
    if (!ahead || !on_a_new_page) continue;
    lod_.show_at_once(update);
    details.follow_track(updates.subspan(i, 1));  // for the pose of now
  }
}

// Feet are placed for agents that are evaluated each frame and not ahead, so that it is known where the feet are;
// without level of detail, for all.
void PosedCrowd::place_feet(const Frame& frame, const anim::AgentUpdate& update, bool near_by) const {
  const bool everyone = frame.tuning.lod.rule == anim::LodRule::off;
  const anim::LodChoice choice = lod_.choice(update.agent.number);
  const bool stand =
      frame.tuning.placed_feet && choice.bone_level == 0 && (everyone || (near_by && choice.interval == 1));
  frame.animated.details().place_feet(update.agent.number, stand, shown_.pose(update.agent.number).shown());
}

/// Takes a slot for the pose of an agent in view.
void PosedCrowd::show(const Frame& frame, anim::AgentUpdate& update) {
  const std::uint32_t agent = update.agent.number;
  const std::uint8_t character = frame.crowd.characters()[agent];
  const NewPose pose{.agent = agent,
                     .level = update.level,
                     .entries = characters_[character].character->level_entries[update.level],
                     .time = shader_time(frame.system.clock() + update.look_ahead),
                     .format = frame.system.characters().palette_format(character)};
  const anim::PaletteDestination memory = shown_.show(pose, frame.now, frame.last);
  update.palette = meter_.destination(agent, shown_.pose(agent), pose.entries, memory);
  update.joints = joints_.destination(agent);
}

// Rag-dolls have no pose that could be looked ahead to, and fall on out of view too.
void PosedCrowd::add_fallen(const Frame& frame) {
  for (const FallenAgents::Fallen& fallen : frame.animated.fallen().fallen()) {
    const ShownPose& pose = shown_.pose(fallen.agent);
    const bool looked_ahead = pose.shown() && static_cast<std::int32_t>(pose.to_time - frame.now) > 0;
    if (looked_ahead || (!frame.seen.moves && pose.shown())) continue;
    anim::AgentUpdate& update = lod_.update_also(fallen.agent);
    if (lod_.is_visible(fallen.agent)) show(frame, update);
  }
}

void PosedCrowd::measure(const Frame& frame) {
  const glm::vec2 size = frame.seen.size;
  meter_.end_frame(frame.system, {.tuning = frame.tuning,
                                  .crowd = frame.crowd,
                                  .visible = selection().visible,
                                  .mesh_lods = mesh_lods_,
                                  .mesh_of_visible = mesh_choice_.lods(),
                                  .shown = shown_,
                                  .view = render::view_of(frame.seen.camera, size.x / size.y),
                                  .size = size,
                                  .now = frame.now,
                                  .number = frame_});
}

// In the first frames no agent is skipped yet, so errors are too small to learn from. One of few agents is more
// than the hundredth part, and a calm agent says nothing of its next motion.
void PosedCrowd::settle(const Frame& frame) {
  const anim::ErrorFigures error = meter_.pose_figures();
  const bool tells = error.p99_is_known() && error.frames >= anim::ErrorWindow::frames &&
                     selection().visible.size() >= least_agents_to_learn_from;
  lod_.settle(frame.system.figures().report().predicted_nanoseconds, tells ? std::optional(error.p99) : std::nullopt);
}

void PosedCrowd::pose_exactly(AnimatedCrowd& animated) {
  anim::AnimationSystem& system = animated.system();
  exact_.give_back(frame_);
  for (const anim::VisibleAgent& each : selection().visible) {
    const ShownPose& shown = shown_.pose(each.agent);
    const bool known = shown.shown() && std::as_const(system).agent(each.agent).can_pose_exactly();
    const CharacterSource& character = characters_[animated.crowd().characters()[each.agent]];
    exact_.add(each.agent, shown, known ? character.character->level_entries.front() : 0);
  }
  exact_.pose(system);
}

}  // namespace throng::app
