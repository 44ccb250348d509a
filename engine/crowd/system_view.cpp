#include "engine/crowd/system_view.h"

#include <utility>

namespace throng {
namespace {

constexpr std::size_t least_agents_to_learn_from = 100;

std::vector<std::size_t> palette_sizes(std::span<const ViewedCharacter> characters,
                                       std::span<const std::size_t> more_sizes) {
  std::vector<std::size_t> sizes(more_sizes.begin(), more_sizes.end());
  for (const ViewedCharacter& viewed : characters) {
    for (const std::uint32_t entries : viewed.character->level_entries) {
      sizes.push_back(anim::palette_stride(entries, PaletteFormat::matrices));
      sizes.push_back(anim::palette_stride(entries, PaletteFormat::packed));
    }
  }
  return sizes;
}

}  // namespace

std::uint32_t shader_time(Ticks clock) { return static_cast<std::uint32_t>(clock * 10 / (ticks_per_second / 100'000)); }

anim::LodCharacter lod_character(const ViewedCharacter& viewed) {
  anim::LodCharacter character = anim::lod_character(*viewed.character);
  character.full_rate_nanoseconds = viewed.full_rate_nanoseconds;
  return character;
}

SystemView::SystemView(std::vector<ViewedCharacter> characters, render::PalettePageSource& pages,
                       std::uint64_t first_frame, std::span<const std::size_t> more_sizes)
    : characters_(std::move(characters)),
      slots_(pages, palette_sizes(characters_, more_sizes)),
      shown_(slots_),
      exact_(slots_),
      meter_(characters_),
      mesh_lods_(characters_.size()),
      frame_(first_frame) {
  learn_level_of_detail();
}

void SystemView::learn_level_of_detail() {
  std::vector<anim::LodCharacter> characters;
  for (const ViewedCharacter& viewed : characters_) characters.push_back(throng::lod_character(viewed));
  lod_.set_characters(std::move(characters));
}

void SystemView::set_characters(std::vector<ViewedCharacter> characters) {
  characters_ = std::move(characters);
  learn_level_of_detail();
  meter_ = ErrorMeter(characters_);
  mesh_lods_ = MeshLods(characters_.size());
}

void SystemView::restart() {
  meter_ = ErrorMeter(characters_);
  lod_.restart();
}

void SystemView::reset(std::size_t agents, const LodRules& rules) {
  exact_.reset(agents, frame_);
  forget_shown(agents, rules);
}

void SystemView::forget_shown(std::size_t agents, const LodRules& rules) {
  agents_ = agents;
  lod_.reset(agents, rules);
  mesh_choice_.reset(agents);
  shown_.reset(agents, frame_);
  meter_.reset(agents);
}

// Slots keep their sizes: a pose goes to the next larger one.
void SystemView::take_character(std::size_t character, const ViewedCharacter& viewed) {
  characters_[character] = viewed;
  learn_level_of_detail();
  meter_.set_character(character, viewed);
  meter_.reset(agents_);
  shown_.reset(agents_, frame_);
  lod_.forget_shown();
  lod_.make_all_due();
}

void SystemView::choose(anim::AnimationSystem& system, const SystemFrame& frame) {
  const std::uint64_t last = frame_++;
  now_ = shader_time(system.clock());
  const int jobs = system.options().pus;
  exact_.give_back(last);
  slots_.reclaim(frame.completed);
  lod_.select({.positions = frame.agents.positions,
               .scales = frame.agents.scales,
               .character_of = frame.agents.characters,
               .clips = frame.clips,
               .left_out = frame.left_out,
               .absent = frame.absent},
              {.camera = frame.camera,
               .rules = frame.rules.lod,
               .force = frame.rules.force,
               .selected = frame.selected,
               .now = system.clock(),
               .frame_step = frame.step},
              system.executor(), jobs);
  const std::span<const anim::VisibleAgent> visible = selection().visible;
  mesh_choice_.choose(visible, frame.agents.characters, mesh_lods_, frame.rules.meshes, system.executor(), jobs);
  shown_.hide_unseen(lod_, last, system.executor(), jobs);
  meter_.begin_frame(frame.sampling, visible, shown_);
}

bool SystemView::show(const anim::AnimationSystem& system, const SystemFrame& frame, PoseRequest& update) {
  const std::uint32_t agent = update.agent.number;
  const std::uint8_t character = frame.agents.characters[agent];
  const NewPose pose{.agent = agent,
                     .level = update.level,
                     .entries = characters_[character].character->level_entries[update.level],
                     .time = shader_time(system.clock() + update.look_ahead),
                     .format = system.characters().palette_format(character)};
  std::byte* const memory = shown_.show(pose, now_, frame_ - 1);
  update.palette = meter_.destination(agent, shown_.pose(agent), pose.entries, memory);
  if (update.look_ahead <= Ticks{} || shown_.pose(agent).to_time != now_) return false;
  lod_.show_at_once(update);
  return true;
}

PoseRequest& SystemView::show_also(const anim::AnimationSystem& system, const SystemFrame& frame, std::uint32_t agent) {
  PoseRequest& update = lod_.update_also(agent);
  if (lod_.is_visible(agent)) show(system, frame, update);
  return update;
}

void SystemView::pose(anim::AnimationSystem& system, const SystemFrame& frame) {
  system.update(lod_.updates());
  measure(system, frame);
  settle(system);
}

void SystemView::measure(anim::AnimationSystem& system, const SystemFrame& frame) {
  meter_.end_frame(system, {.rules = frame.rules,
                            .agents = frame.agents,
                            .visible = selection().visible,
                            .mesh_lods = mesh_lods_,
                            .mesh_of_visible = mesh_choice_.lods(),
                            .shown = shown_,
                            .view = frame.view,
                            .projection = frame.projection,
                            .size = frame.size,
                            .now = now_,
                            .number = frame_});
}

// In the first frames no agent is skipped yet, so errors are too small to learn from. One of few agents is more
// than the hundredth part, and a calm agent says nothing of its next motion.
void SystemView::settle(const anim::AnimationSystem& system) {
  const anim::ErrorFigures error = meter_.pose_figures();
  const bool tells = error.p99_is_known() && error.frames >= anim::ErrorWindow::frames &&
                     selection().visible.size() >= least_agents_to_learn_from;
  lod_.settle(system.figures().report().predicted_nanoseconds, tells ? std::optional(error.p99) : std::nullopt);
}

void SystemView::pose_exactly(anim::AnimationSystem& system, const PlacedAgents& agents) {
  exact_.give_back(frame_);
  for (const anim::VisibleAgent& each : selection().visible) {
    const ShownPose& shown = shown_.pose(each.agent);
    const bool known = shown.shown() && std::as_const(system).agent(each.agent).can_pose_exactly();
    const ViewedCharacter& viewed = characters_[agents.characters[each.agent]];
    exact_.add(each.agent, shown, known ? viewed.character->level_entries.front() : 0);
  }
  exact_.pose(system);
}

}  // namespace throng
