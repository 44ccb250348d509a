#include "app/stage/stage.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <thread>
#include <utility>

#include <glm/geometric.hpp>

#include "app/character/cut_scene_models.h"

namespace throng::app {
namespace {

constexpr float push_impulse = 60.0F;      // kg m/s: a hard shove
constexpr double push_height = 0.75;       // of the character's, where it is met
constexpr float least_body_radius = 0.2F;  // metres, to click at

using EntriesByLevel = std::vector<std::vector<std::uint32_t>>;  // [character][bone level]

EntriesByLevel entries_by_level(std::span<const CharacterSource> characters) {
  EntriesByLevel entries;
  for (const CharacterSource& source : characters) {
    entries.push_back(source.character->level_entries);
  }
  return entries;
}

std::vector<std::size_t> all_sizes(const EntriesByLevel& entries) {
  std::vector<std::size_t> sizes;
  for (const auto& of_character : entries) {
    for (const std::uint32_t count : of_character) {
      sizes.push_back(anim::palette_stride(count, anim::PaletteFormat::matrices));
      sizes.push_back(anim::palette_stride(count, anim::PaletteFormat::packed));
    }
  }
  return sizes;
}

std::vector<CharacterRoles> roles_of(std::span<const CharacterSource> characters) {
  std::vector<CharacterRoles> roles;
  for (const CharacterSource& character : characters) roles.push_back(character.roles);
  return roles;
}

constexpr auto cost_of_placed_feet =
    static_cast<std::uint32_t>(anim::foot_placement_work * anim::CostModel{}.post_process);

anim::LodCharacter lod_character(const CharacterSource& source) {
  return {.centre_height = static_cast<float>(source.bounds.height / 2.0),
          .radius = static_cast<float>(source.bounds.reach),
          .height = static_cast<float>(source.bounds.height),
          .level_count = static_cast<int>(source.character->skeleton.level_bone_counts.size()),
          .level_error_metres = source.character->bone_lod.level_error_metres,
          .update_nanoseconds = update_costs(source.character->skeleton, anim::CostModel{}),
          .full_rate_nanoseconds = source.roles.is_prop ? 0 : cost_of_placed_feet,
          .clips = source.character->skip_errors};
}

bool same_crowd(const Tuning& a, const Tuning& b) {
  return a.scene == b.scene && a.agents == b.agents && a.seed == b.seed;
}

std::string joined(std::span<const std::string> sentences) {
  std::string all;
  for (const std::string& sentence : sentences) all += (all.empty() ? "" : "; ") + sentence;
  return all;
}

}  // namespace

anim::SystemOptions on_this_machine(anim::SystemOptions options) {
  if (options.pus == 0) options.pus = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return options;
}

Stage::Stage(std::vector<CharacterSource> characters, render::PalettePageSource& pages)
    : characters_(std::move(characters)),
      palette_entries_(entries_by_level(characters_)),
      slots_(pages, all_sizes(palette_entries_)),
      shown_(slots_),
      exact_(slots_),
      meter_(characters_) {
  learn_level_of_detail();
}

void Stage::learn_level_of_detail() {
  lod_characters_.clear();
  std::ranges::transform(characters_, std::back_inserter(lod_characters_), lod_character);
  crowd_lod_ = CrowdLod();
  crowd_lod_.set_characters(lod_characters_);
}

anim::Result<std::unique_ptr<Stage>> Stage::create(std::vector<CharacterSource> characters, const Tuning& tuning,
                                                   render::PalettePageSource& pages, std::uint64_t first_frame) {
  characters.push_back(balloon(app::common_roles(roles_of(characters)).size()));
  std::unique_ptr<Stage> stage(new Stage(std::move(characters), pages));
  stage->tuning_ = tuning;
  stage->frame_ = first_frame;
  if (const anim::Status opened = stage->open_system(); !opened) return opened.error();
  stage->populate();
  return stage;
}

anim::Status Stage::open_system() {
  auto system = anim::AnimationSystem::create(characters_.front().character, on_this_machine(tuning_.system));
  if (!system) return system.error();
  system_ = std::move(*system);
  for (const CharacterSource& more : std::span(characters_).subspan(1)) {
    if (const auto added = system_->characters().add(more.character); !added) {
      return anim::Error{more.name + ": " + added.error().message};
    }
  }
  const auto camera = system_->characters().add(film_camera(common_roles().size()));
  if (!camera) return camera.error();
  film_camera_ = *camera;
  std::vector<std::optional<anim::EntityPools::Kind>> ragdolls, feet;
  for (std::uint32_t character = 0; character < characters_.size(); ++character) {
    rigs_.push_back(std::make_unique<anim::CharacterRigs>(characters_[character].model));
    const anim::RigKinds kinds = rigs_.back()->add_to(*system_, character);
    ragdolls.push_back(kinds.ragdoll);
    feet.push_back(kinds.foot_placement);
  }
  fallen_ = std::make_unique<FallenAgents>(std::move(ragdolls), *system_);
  feet_ = std::make_unique<PlacedFeet>(std::move(feet), *system_);
  return anim::Done{};
}

std::span<const CharacterSource> Stage::people() const {
  const auto prop = std::ranges::find_if(characters_, [](const CharacterSource& each) { return each.roles.is_prop; });
  return {characters_.begin(), prop};
}

CharacterRoles Stage::common_roles() const { return app::common_roles(roles_of(characters_)); }

anim::Status Stage::apply(const Tuning& tuning) {
  const anim::SystemOptions options = on_this_machine(tuning.system);
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

void Stage::set_roles(std::size_t character, const RoleClips& clips) {
  assign_roles(characters_[character], clips);
  if (!moving_) lod_.make_all_due();
  populate();
}

// Slots keep their sizes: a pose goes to the next larger one.
anim::Status Stage::set_bone_lod(std::size_t character, const BoneLodChoice& choice) {
  CharacterSource& source = characters_[character];
  if (const anim::Status checked = check_bone_lod(source.character->skeleton, choice); !checked) return checked;
  const ReorderedCharacter reordered = in_order(source, choice);
  const auto number = static_cast<std::uint32_t>(character);
  const anim::Status replaced = system_->characters().replace(number, reordered.character, reordered.places);
  if (!replaced) return replaced;
  anim::reorder_bones(source.model, choice);
  source.character = reordered.character;
  rigs_[character]->reorder_bones(reordered.places);
  palette_entries_ = entries_by_level(characters_);
  lod_characters_[character] = lod_character(source);
  crowd_lod_.set_characters(lod_characters_);
  meter_.set_character(character, source);
  meter_.reset(crowd_->size());
  ++crowd_number_;  // moments of it are of other blocks
  shown_.reset(crowd_->size(), frame_);
  lod_.make_all_due();
  return anim::Done{};
}

void Stage::restart() {
  moving_ = true;
  meter_ = ErrorMeter(characters_);
  learn_level_of_detail();
  populate(Clocks::begin_anew);
}

void Stage::populate(Clocks clocks) {
  const auto agents = static_cast<std::size_t>(tuning_.agents);
  crowd_ = std::make_unique<Crowd>(tuning_.scene, agents, tuning_.seed, roles_of(characters_));
  ++crowd_number_;
  selected_.reset();
  held_clip_.reset();
  fallen_->reset();
  feet_->reset(agents);
  system_->set_agent_count(0);
  if (clocks == Clocks::begin_anew) {
    system_->restart();
    frames_moved_ = 0;
  }
  cut_scene_.reset();
  system_->add_agents(crowd_->characters());
  played_speeds_.assign(agents, 0.0F);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    request_clip(agent, crowd_->clips()[agent], 0, static_cast<double>(crowd_->start_phases()[agent]));
  }
  if (tuning_.scene == Scene::film) {
    cut_scene_ = std::make_unique<CutScene>(*system_, *crowd_, characters_, film_camera_);
  }
  lod_.resize(agents, selection_);
  crowd_lod_.reset(agents, tuning_);
  bone_steps_.assign(agents, {});
  shown_.reset(agents, frame_);
  exact_.reset(agents, frame_);
  meter_.reset(agents);
  updates_.reserve(agents);
  if (event_sums_) event_sums_->reset(agents);
}

void Stage::sum_up_events() { event_sums_.emplace().reset(crowd_->size()); }

void Stage::request_clip(std::uint32_t agent, int clip, anim::Ticks fade, double start_phase) {
  const int index = clip == no_clip ? 0 : clip;
  const anim::Ticks duration = character_of(agent).character->clips[static_cast<std::size_t>(index)].duration;
  const bool plays = clip != no_clip;
  played_speeds_[agent] = crowd_->playback_speeds()[agent];
  const bool is_made = agent < lod_.is_called.size();  // else the crowd is being made
  if (is_made && system_->agent(agent).can_wind_back()) lod_.make_due(agent);
  crowd_lod_.fade(agent, system_->clock() + fade);
  system_->agent(agent).play(
      {.clip = index,
       .fade = fade,
       .speed = plays ? static_cast<double>(crowd_->playback_speeds()[agent]) : 0.0,
       .start = plays ? static_cast<anim::Ticks>(start_phase * static_cast<double>(duration)) : 0});
}

void Stage::request_clip(const std::optional<ClipRequest>& request) {
  if (!request) return;
  request_clip(request->agent, request->clip, anim::to_ticks(static_cast<double>(request->fade_seconds)), 0.0);
}

bool Stage::can_fall(std::uint32_t agent) const {
  return fallen_->possible(agent) && crowd_->habits()[agent] != Habit::act;
}

anim::Status Stage::push_over(std::uint32_t agent, const glm::vec3& direction) {
  const CharacterSource& character = character_of(agent);
  if (crowd_->habits()[agent] == Habit::act) return anim::Error{"nobody who acts in the cut scene can be pushed over"};
  if (!can_fall(agent)) {
    const std::string missing = joined(rigs_[crowd_->characters()[agent]]->missing());
    return anim::Error{character.name + " cannot be pushed over: " + missing};
  }
  if (holds_clip(agent)) let_go_of_clip();
  const Heading heading = crowd_->headings()[agent];
  const glm::vec2 way(heading.cosine * direction.x - heading.sine * direction.z,
                      heading.sine * direction.x + heading.cosine * direction.z);
  const glm::vec2 impulse = way * (push_impulse / std::max(glm::length(way), 1e-3F));
  const bool stood = !crowd_->holds(agent);
  if (stood) request_clip(crowd_->hold(agent));
  const auto chest = static_cast<float>(push_height * character.bounds.height);
  const anim::Status pushed = fallen_->push(agent, {impulse.x, 0.0F, impulse.y}, {0.0F, chest, 0.0F});
  if (!pushed && stood) request_clip(crowd_->release(agent));
  return pushed;
}

// Somebody who lies is as long as they were tall, in any direction.
UprightBody Stage::body_of(std::uint32_t agent) const {
  const float scale = crowd_->scales()[agent];
  const anim::CharacterBounds& bounds = character_of(agent).bounds;
  const float height = static_cast<float>(bounds.height) * scale;
  const float radius = std::max(static_cast<float>(bounds.body_radius), least_body_radius) * scale;
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

}  // namespace throng::app
