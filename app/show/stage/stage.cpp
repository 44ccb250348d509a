#include "app/show/stage/stage.h"

#include <algorithm>
#include <utility>

#include "app/character/body_parts.h"
#include "app/character/cut_scene_models.h"
#include "app/people/wardrobe/cast_rules_text.h"
#include "app/people/wardrobe/rule_doubts.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/stage/memory_needs.h"
#include "app/show/stage/moment.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

constexpr float least_clicked_radius = 0.2F;  // metres: a smaller body could hardly be hit

/// Reads what agents may wear, and tells the crowd of the bodies that there are.
Result<std::vector<Clothing>> clothing_of_all(std::vector<CharacterSource>& characters) {
  std::vector<Clothing> all;
  for (CharacterSource& source : characters) {
    auto clothing = clothing_of(source);
    if (!clothing) return clothing.error();
    source.roles.bodies = body_kinds(clothing->rules);
    source.rules = rules_text(clothing->rules);
    all.push_back(std::move(*clothing));
  }
  return all;
}

bool same_crowd(const Tuning& a, const Tuning& b) {
  const bool same_clothes = !a.wardrobe || a.weather == b.weather;  // and things in hands
  return a.scene == b.scene && a.agents == b.agents && a.seed == b.seed && variety_of(a) == variety_of(b) &&
         same_clothes;
}

}  // namespace

Stage::Stage(std::vector<CharacterSource> characters, render::PalettePageSource& pages, std::uint64_t first_frame)
    : characters_(std::move(characters)), posed_(characters_, pages, first_frame) {}

Result<std::unique_ptr<Stage>> Stage::create(std::vector<CharacterSource> characters, const Tuning& tuning,
                                             render::PalettePageSource& pages, std::uint64_t first_frame,
                                             std::shared_ptr<const Trajectories> trajectories) {
  characters.push_back(balloon(app::common_roles(roles_of(characters)).size()));
  auto clothing = clothing_of_all(characters);
  if (!clothing) return clothing.error();
  std::unique_ptr<Stage> stage(new Stage(std::move(characters), pages, first_frame));
  stage->clothing_ = std::move(*clothing);
  stage->tuning_ = tuning;
  stage->trajectories_ = std::move(trajectories);
  if (Status shown = stage->can_show(stage->tuning_); !shown) return shown.error();
  auto animated = AnimatedCrowd::create(stage->characters_, tuning.system, stage->posed_.level_of_detail());
  if (!animated) return animated.error();
  stage->animated_ = std::move(*animated);
  stage->populate();
  return stage;
}

std::span<const CharacterSource> Stage::people() const {
  const auto prop = std::ranges::find_if(characters_, [](const CharacterSource& each) { return each.roles.is_prop; });
  return {characters_.begin(), prop};
}

// A recorded crowd has as many people as it has.
Status Stage::can_show(Tuning& tuning) const {
  if (tuning.scene != Scene::tracks) return Done{};
  if (trajectories_ == nullptr) {
    return Error{"scene tracks: no file of trajectories is open; start with --trajectories FILE"};
  }
  tuning.agents = static_cast<int>(trajectories_->persons.size());
  return Done{};
}

Status Stage::apply(const Tuning& asked) {
  Tuning tuning = asked;
  if (Status shown = can_show(tuning); !shown) return shown;
  if (Status fits = check_memory(tuning, characters_, &tuning_); !fits) return fits;
  if (Status configured = animated_->configure(tuning.system); !configured) return configured;
  const bool keeps_crowd = same_crowd(tuning, tuning_);
  tuning_ = tuning;
  if (!moving_)
    posed_.level_of_detail().make_all_due();  // no agent's turn comes while time stands still, but tuning shows at once
  if (!keeps_crowd) populate();
  return Done{};
}

void Stage::set_roles(std::size_t character, const RoleClips& clips, std::optional<double> share) {
  CharacterRoles& roles = characters_[character].roles;
  const bool walked = roles.can_walk();
  assign_roles(characters_[character], clips);
  if (share) roles.share = *share;
  const bool keeps_places =
      !share && roles.can_walk() == walked && tuning_.scene != Scene::film && tuning_.scene != Scene::tracks;
  if (!keeps_places) return populate();
  animated_->take_roles();
  if (!moving_) posed_.level_of_detail().make_all_due();
}

Status Stage::set_bone_lod(std::size_t character, const BoneLodChoice& choice) {
  CharacterSource& source = characters_[character];
  if (Status checked = check_bone_lod(source.character->skeleton, choice); !checked) return checked;
  const std::vector<int> places = anim::bone_places(choice);
  const std::shared_ptr<const anim::Character> played = source.character;
  const PackedSurface drawn = source.surface;
  take_order(source, choice);
  if (Status replaced = animated_->reorder_bones(character, source.character, places); !replaced) {
    anim::reorder_bones(source.model, {.bones = places, .level_counts = played->skeleton.level_bone_counts});  // back
    source.character = played;
    source.surface = drawn;
    return replaced;
  }
  source.order_is_chosen = true;
  posed_.take_character(character, viewed_character(source));
  return Done{};
}

// Blocks of agents lie as the rigs of their character ask, so a system has the rigs that it was made with.
Status Stage::set_rig(std::size_t character, const std::vector<RigChoice>& choices) {
  CharacterSource& source = characters_[character];
  std::vector<RigChoice> rig_before = source.rig;
  std::vector<anim::Bone> bones_before = source.model.skeleton.bones;
  if (Status taken = take_rig(source, choices); !taken) return taken;
  auto animated = AnimatedCrowd::create(characters_, tuning_.system, posed_.level_of_detail());
  if (!animated) {
    source.rig = std::move(rig_before);
    source.model.skeleton.bones = std::move(bones_before);
    return animated.error();
  }
  const bool sums_up_events = animated_->event_sums().has_value();
  animated_ = std::move(*animated);
  restart();
  if (sums_up_events) animated_->sum_up_events();
  return Done{};
}

Status Stage::set_cast_rules(std::size_t character, CastRules rules, const std::string& file) {
  CharacterSource& source = characters_[character];
  Clothing& clothing = clothing_[character];
  if (std::string wrong = wrong_for(rules, clothing.wardrobe); !wrong.empty()) return Error{std::move(wrong)};
  source.rules = rules_text(rules);
  if (!file.empty()) source.cast_rules = file, clothing.origin = plain_text(file);
  source.roles.bodies = body_kinds(rules);
  const bool is_other = rules != clothing.rules;
  source.rules_are_chosen = source.rules_are_chosen || is_other || !file.empty();
  clothing.rules = std::move(rules);
  clothing.doubts = doubts_of(clothing.rules, clothing.wardrobe);
  if (is_other && tuning_.wardrobe) populate();
  return Done{};
}

void Stage::restart() {
  moving_ = true;
  posed_.restart();
  populate(AnimatedCrowd::Clocks::begin_anew);
}

void Stage::populate(AnimatedCrowd::Clocks clocks) {
  animated_->populate(tuning_, clocks, clothing_, track_source(trajectories_, characters_));
  if (crowd().tracks() != nullptr) {
    if (track_clock_) animated_->crowd().go_to(*track_clock_);
    track_clock_ = crowd().tracks()->clock();
  }
  selected_.reset();
  posed_.reset(crowd().size(), lod_rules(tuning_));
}

// No agent flies or slides from its place before: all agents are posed at once, and feet come down anew.
void Stage::jump() {
  posed_.forget_shown(crowd().size(), lod_rules(tuning_));
  animated_->details().take_back({});
}

void Stage::set_track_clock(const TrackClock& clock) {
  track_clock_ = clock;
  if (crowd().tracks() == nullptr) return;
  animated_->crowd().go_to(clock);
  jump();
}

void Stage::take_live_step(const LiveStep& step) {
  if (crowd().tracks() == nullptr) return;
  animated_->crowd().take(step, animated_->system().executor(), system().options().pus);
}

void Stage::move(Ticks delta) {
  StopWatch watch;
  moving_ = delta > Ticks{};
  const FollowedTracks* const tracks = crowd().tracks();
  const double seconds = tracks != nullptr ? tracks->clock().seconds : 0.0;
  animated_->move(delta);
  if (tracks != nullptr) {
    track_clock_ = tracks->clock();
    if ((track_clock_->seconds - seconds) * track_clock_->rate < 0.0) jump();  // the part begins anew
  }
  times_.crowd_ms = watch.lap();
}

std::uint32_t Stage::now() const { return shader_time(system().clock()); }

void Stage::pose(const render::Camera& camera, int width, int height, Ticks frame_step, std::uint64_t completed_frame) {
  posed_.pose(*animated_,
              {.camera = camera,
               .size = {static_cast<float>(width), static_cast<float>(height)},
               .step = frame_step,
               .moves = moving_,
               .selected = selected_,
               .completed = completed_frame},
              tuning_, times_);
}

void Stage::select(std::optional<std::uint32_t> agent) {
  const auto& held = animated_->held_clip();
  if (held && held->agent != agent) animated_->let_go_of_clip();
  selected_ = agent;
}

Status Stage::go_back_to(const StageMoment& moment) {
  Status gone = animated_->go_back_to(moment);
  if (gone) posed_.forget_shown(crowd().size(), lod_rules(tuning_));  // those are poses of the future
  return gone;
}

// An agent that lies is as long as it was tall, in any direction.
UprightBody body_of(const Stage& stage, std::uint32_t agent) {
  const Crowd& crowd = stage.crowd();
  const float scale = crowd.scales()[agent];
  const anim::CharacterBounds& bounds = stage.character_of(agent).character->bounds;
  const float height = static_cast<float>(bounds.height) * scale;
  const float radius = static_cast<float>(bounds.body_radius) * scale;
  UprightBody body{.agent = agent, .foot = crowd.positions()[agent], .radius = radius, .height = height};
  const std::optional<glm::vec3> hips = stage.animated().fallen().hips(agent);
  if (!hips || hips->y * scale > height / 4.0F) return body;
  const Heading heading = crowd.headings()[agent];
  const glm::vec2 aside(heading.cosine * hips->x + heading.sine * hips->z,
                        heading.cosine * hips->z - heading.sine * hips->x);
  body.foot += scale * glm::vec3(aside.x, 0.0F, aside.y);
  body.radius = height / 2.0F;
  body.height = height / 4.0F;
  return body;
}

std::vector<UprightBody> bodies_in_view(const Stage& stage) {
  std::vector<UprightBody> bodies;
  bodies.reserve(stage.posed().selection().visible.size());
  for (const anim::VisibleAgent& agent : stage.posed().selection().visible) {
    UprightBody& body = bodies.emplace_back(body_of(stage, agent.agent));
    body.radius = std::max(body.radius, least_clicked_radius);
  }
  return bodies;
}

}  // namespace throng::app
