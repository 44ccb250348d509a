#include "app/show/stage/animated_crowd.h"

#include "app/character/cut_scene_models.h"
#include "app/people/wardrobe/dressed_crowd.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/base/files/cores.h"

namespace throng::app {

anim::SystemOptions on_this_machine(anim::SystemOptions options) {
  if (options.pus == 0) options.pus = usable_cores();
  return options;
}

std::vector<CharacterRoles> roles_of(std::span<const CharacterSource> characters) {
  std::vector<CharacterRoles> roles;
  for (const CharacterSource& character : characters) roles.push_back(character.roles);
  return roles;
}

Result<std::unique_ptr<AnimatedCrowd>> AnimatedCrowd::create(std::span<const CharacterSource> characters,
                                                             const anim::SystemOptions& options,
                                                             anim::LevelOfDetail& lod) {
  std::unique_ptr<AnimatedCrowd> crowd(new AnimatedCrowd(characters, lod));
  if (const Status opened = crowd->open(options); !opened) return opened.error();
  return crowd;
}

Status AnimatedCrowd::open(const anim::SystemOptions& options) {
  auto system = anim::AnimationSystem::create(characters_.front().character, on_this_machine(options));
  if (!system) return system.error();
  system_ = std::move(*system);
  for (const CharacterSource& more : characters_.subspan(1)) {
    if (const auto added = system_->characters().add(more.character); !added) {
      return Error{more.name + ": " + added.error().message};
    }
  }
  const auto camera = system_->characters().add(film_camera(common_roles(roles_of(characters_)).size()));
  if (!camera) return camera.error();
  film_camera_ = camera->number;
  std::vector<anim::RigKinds> kinds;
  std::vector<std::optional<anim::EntityPools::Kind>> ragdolls;
  for (std::uint32_t character = 0; character < characters_.size(); ++character) {
    rigs_.push_back(std::make_unique<anim::CharacterRigs>(characters_[character].model));
    kinds.push_back(rigs_.back()->add_to(*system_, character));
    ragdolls.push_back(kinds.back().ragdoll);
  }
  fallen_ = std::make_unique<FallenAgents>(std::move(ragdolls), *system_);
  details_ = std::make_unique<BodyDetails>(characters_, rigs_, kinds, *system_);
  return Done{};
}

Status AnimatedCrowd::configure(const anim::SystemOptions& options) {
  const anim::SystemOptions here = on_this_machine(options);
  return here == system_->options() ? Status(Done{}) : system_->configure(here);
}

Status AnimatedCrowd::reorder_bones(std::size_t character, std::shared_ptr<const anim::Character> reordered,
                                    std::span<const int> places) {
  const auto number = static_cast<std::uint32_t>(character);
  rigs_[character]->reorder_bones(places);
  Status replaced = system_->characters().replace(number, std::move(reordered), places);
  if (!replaced) {
    rigs_[character]->reorder_bones(
        anim::bone_places({.bones = {places.begin(), places.end()}, .level_counts = {}}));  // back
    return replaced;
  }
  ++number_;  // moments of it are of other blocks
  return replaced;
}

void AnimatedCrowd::populate(const Tuning& tuning, Clocks clocks, std::span<const Clothing> clothing,
                             const TrackSource& tracks) {
  const auto agents = static_cast<std::size_t>(tuning.agents);
  crowd_ =
      std::make_unique<Crowd>(tuning.scene, agents, tuning.seed, roles_of(characters_), variety_of(tuning), tracks);
  ++number_;
  held_clip_.reset();
  details_->reset(*crowd_);
  fallen_->reset(agents);
  system_->set_agent_count(0);
  if (clocks == Clocks::begin_anew) system_->restart();
  began_at_ = system_->clock();
  cut_scene_.reset();
  system_->add_agents(crowd_->characters());
  played_speeds_.assign(agents, 0.0F);
  new_speeds_.set_aside(agents);
  if (crowd_->tracks() != nullptr) {
    details_->follow_tracks();
  } else {
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      play(agent, crowd_->minds().clips()[agent], Ticks{}, static_cast<double>(crowd_->looks().start_phases[agent]));
    }
  }
  if (tuning.scene == Scene::film) {
    cut_scene_ = std::make_unique<CutScene>(*system_, *crowd_, characters_, film_camera_);
  }
  if (event_sums_) event_sums_->reset(agents);
  if (tuning.wardrobe) dress(clothing, tuning);
}

void AnimatedCrowd::give(std::vector<HeldThing> things) {
  crowd_->minds().give(std::move(things));
  details_->find_things();
}

// Many agents take a new clip at once, so each begins where it would have begun with the clip.
void AnimatedCrowd::take_roles() {
  let_go_of_clip();
  for (const ClipRequest& request : crowd_->take_roles(roles_of(characters_))) {
    change_clip(request.agent, request.clip, to_ticks(static_cast<double>(request.fade_seconds)),
                static_cast<double>(crowd_->looks().start_phases[request.agent]));
  }
  ++number_;
}

void AnimatedCrowd::move(Ticks delta) {
  const Ticks before = system_->clock();
  system_->advance(delta);
  if (event_sums_) event_sums_->add_events(*system_, before);
  const auto requests = crowd_->advance(delta, system_->executor(), system_->options().pus);
  if (event_sums_) event_sums_->add_places(*crowd_);
  for (const ClipRequest& request : requests) change_clip(request);
  match_playback();
  if (cut_scene_ && delta > Ticks{}) cut_scene_->advance();
}

// Agents that walk go at their own pace from frame to frame, and their feet with them.
void AnimatedCrowd::match_playback() {
  const std::span<const float> speeds = crowd_->playback_speeds();
  const std::size_t movers = crowd_->walkers().count() + crowd_->marchers().count();
  const auto pick = [&](std::size_t i, SpeedRequest& listed) {
    const auto agent = static_cast<std::uint32_t>(i);
    if (speeds[agent] == played_speeds_[agent] || crowd_->minds().clips()[agent] == no_clip || holds_clip(agent))
      return false;
    listed = {.agent = {agent}, .speed = speeds[agent]};
    played_speeds_[agent] = speeds[agent];
    return true;
  };
  system_->many().set_speeds(new_speeds_.gather(movers, system_->executor(), system_->options().pus, pick));
}

void AnimatedCrowd::play(std::uint32_t agent, int clip, Ticks fade, double start_phase) {
  const bool plays = clip != no_clip;
  const int index = plays ? clip : 0;
  const Ticks duration = character_of(agent).character->clips[static_cast<std::size_t>(index)].duration;
  played_speeds_[agent] = crowd_->playback_speeds()[agent];
  system_->agent(agent).play(
      {.clip = index,
       .fade = fade,
       .speed = plays ? static_cast<double>(played_speeds_[agent]) : 0.0,
       .start =
           plays ? Ticks{static_cast<std::int64_t>(start_phase * static_cast<double>(duration.count()))} : Ticks{}});
}

void AnimatedCrowd::change_clip(std::uint32_t agent, int clip, Ticks fade, double start_phase) {
  if (system_->agent(agent).can_wind_back()) lod_->make_due(agent);
  lod_->change_clip(agent, system_->clock() + fade);
  play(agent, clip, fade, start_phase);
}

void AnimatedCrowd::change_clip(const std::optional<ClipRequest>& request) {
  if (request) change_clip(request->agent, request->clip, to_ticks(static_cast<double>(request->fade_seconds)));
}

void AnimatedCrowd::dress(std::span<const Clothing> clothing, const Tuning& tuning) {
  DressedCrowd dressed = dress_crowd(*crowd_, clothing, tuning);
  crowd_->looks().wear(std::move(dressed.looks), std::move(dressed.outfits), std::move(dressed.in_hand));
  give(std::move(dressed.things));
}

}  // namespace throng::app
