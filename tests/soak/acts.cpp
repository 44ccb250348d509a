#include "tests/soak/acts.h"

#include <algorithm>
#include <iterator>

#include "tests/soak/round.h"

namespace throng::soak {
namespace {

using app::Show;

struct Act {
  const char* name;
  std::uint32_t weight;
  anim::Status (*run)(Show&, const Models&, Random&);
};

std::uint32_t any_agent(const Show& show, Random& random) {
  return random.below(static_cast<std::uint32_t>(show.stage().crowd().size()));
}

std::size_t any_character(const Show& show, Random& random) {
  return random.below(static_cast<std::uint32_t>(show.stage().people().size()));
}

anim::Status tune(Show& show, const Models&, Random& random) {
  app::Tuning tuning = show.stage().tuning();
  change_some_values(tuning, random);
  tuning.agents = std::min(tuning.agents, 600);
  tuning.inspection.freeze_camera = random.chance(0.2F);
  tuning.inspection.thresholds = random.chance(0.2F);
  tuning.inspection.figures_above_heads = random.chance(0.2F);
  tuning.inspection.split = static_cast<app::Split>(random.below(3));
  tuning.inspection.split_at = random.unit();
  return show.apply(tuning);
}

anim::Status tune_one_value(Show& show, const Models&, Random& random) {
  app::Tuning tuning = show.stage().tuning();
  const std::span<const app::TuningValue> values = app::tuning_values();
  const app::TuningValue& value = values[random.below(static_cast<std::uint32_t>(values.size()))];
  value.read(tuning, any_text_of(value, random));
  tuning.agents = std::min(tuning.agents, 600);
  return show.apply(tuning);
}

anim::Status select(Show& show, const Models&, Random& random) {
  if (random.chance(0.5F)) {
    show.hands().select(any_agent(show, random));
  } else {
    show.hands().select_at(static_cast<float>(show.width) * random.unit(),
                           static_cast<float>(show.height) * random.unit());
  }
  return anim::Done{};
}

anim::Status push(Show& show, const Models&, Random& random) {
  if (random.chance(0.3F)) return show.hands().push_selected();
  return show.hands().push(any_agent(show, random), {random.between(-1, 1), random.unit(), random.between(-1, 1)});
}

anim::Status hold(Show& show, const Models&, Random& random) {
  if (random.chance(0.3F)) {
    show.hands().let_go_of_clip();
  } else {
    show.hands().hold_clip(any_agent(show, random), random.between(-1, 10));
  }
  return anim::Done{};
}

anim::Status set_roles(Show& show, const Models&, Random& random) {
  const std::size_t character = any_character(show, random);
  const app::CharacterSource& person = show.stage().people()[character];
  app::RoleClips clips = person.roles.clips;
  const auto count = static_cast<std::uint32_t>(person.clip_names.size());
  clips[random.below(app::role_count)] = static_cast<int>(random.below(count + 1)) - 1;
  show.set_roles(character, clips);
  return anim::Done{};
}

anim::Status set_share(Show& show, const Models&, Random& random) {
  show.set_share(any_character(show, random), any_number(random, app::least_share, app::most_share));
  return anim::Done{};
}

anim::Status move_a_bone(Show& show, const Models&, Random& random) {
  const std::size_t character = any_character(show, random);
  const anim::Skeleton& skeleton = show.stage().people()[character].character->skeleton;
  const auto bones = static_cast<std::uint32_t>(skeleton.bones.size());
  std::vector<int> parents;
  for (const auto& bone : skeleton.bones) parents.push_back(bone.parent);
  app::BoneLodChoice choice = app::present_bone_lod(bones, skeleton.level_bone_counts);
  choice = app::with_bone_moved(parents, std::move(choice), random.below(bones), random.below(bones));
  return show.set_bone_lod(character, choice);
}

anim::Status set_rig(Show& show, const Models&, Random& random) {
  const std::size_t character = any_character(show, random);
  const std::vector<std::string> bones = app::bone_keys(show.stage().people()[character].character->skeleton);
  std::vector<app::RigChoice> choices;
  for (std::uint32_t left = random.below(3); left > 0; --left) {
    choices.push_back({static_cast<anim::BodyRole>(random.below(anim::body_role_count)), any_of(random, bones)});
  }
  return show.set_rig(character, choices);
}

anim::Status rewind(Show& show, const Models&, Random&) { return show.rewind(); }

anim::Status replace_models(Show& show, const Models& models, Random& random) {
  std::vector<std::string> files;
  for (std::uint32_t left = 1 + random.below(3); left > 0; --left) files.push_back(any_model(models, random));
  return show.replace_models(files);
}

anim::Status fly(Show& show, const Models&, Random& random) {
  show.camera.position = {random.between(-30, 30), random.between(0.2F, 20), random.between(-30, 30)};
  show.camera.yaw = random.between(-3, 3);
  show.camera.pitch = random.between(-1.5F, 0.5F);
  show.films = random.chance(0.3F);
  return anim::Done{};
}

anim::Status resize(Show& show, const Models&, Random& random) {
  const int width = any_whole_number(random, 1, 900), height = any_whole_number(random, 1, 700);
  if (show.painter().draws()) {
    if (anim::Status set = show.painter().renderer().set_size({width, height}); !set) return set;
  }
  show.width = width;
  show.height = height;
  return anim::Done{};
}

anim::Status draw(Show& show, const Models&, Random& random) {
  if (!show.painter().draws()) return anim::Done{};
  anim::Status drawn = show.draw();
  if (drawn && random.chance(0.3F)) show.painter().renderer().read_image();
  return drawn;
}

anim::Status reload_shaders(Show& show, const Models&, Random&) {
  if (!show.painter().draws()) return anim::Done{};
  return show.painter().renderer().reload_shaders();
}

constexpr Act acts[] = {{"many values", 6, tune},
                        {"one value", 8, tune_one_value},
                        {"select", 4, select},
                        {"push", 8, push},
                        {"hold a clip", 4, hold},
                        {"other roles", 2, set_roles},
                        {"other shares", 2, set_share},
                        {"move a bone", 2, move_a_bone},
                        {"other rig", 2, set_rig},
                        {"rewind", 3, rewind},
                        {"other models", 3, replace_models},
                        {"fly", 6, fly},
                        {"resize", 4, resize},
                        {"draw", 10, draw},
                        {"reload shaders", 1, reload_shaders}};

const Act& any_act(Random& random) {
  std::uint32_t all = 0;
  for (const Act& act : acts) all += act.weight;
  std::uint32_t left = random.below(all);
  const Act* act = std::begin(acts);
  for (; left >= act->weight; ++act) left -= act->weight;
  return *act;
}

}  // namespace

void act_at_random(Show& show, const Models& models, Random& random, Counts& counts) {
  const Act& act = any_act(random);
  const anim::Status done = act.run(show, models, random);
  tell("frame " + std::to_string(show.stage().frame()) + ": " + act.name + (done ? "" : ": " + done.error().message));
  ++counts[act.name];
}

}  // namespace throng::soak
