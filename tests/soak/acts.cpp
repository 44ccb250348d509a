#include "tests/soak/acts.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "app/show/painter.h"
#include "app/show/request/request_json.h"
#include "app/show/stage/stage.h"
#include "tests/soak/round.h"

namespace throng::soak {
namespace {

using app::Show;

/// What a person does to the camera or the picture.
struct Act {
  const char* name;
  std::uint32_t weight;
  Status (*run)(Show&, Random&);
};

using Wished = app::CrowdRequest;

/// A kind of request about the crowd, as a person makes it.
struct Wish {
  std::uint32_t weight;
  Wished (*make)(const Show&, const Models&, Random&);
};

std::uint32_t any_agent(const Show& show, Random& random) {
  return random.below(static_cast<std::uint32_t>(show.stage().crowd().size()));
}

app::CharacterNumber any_character(const Show& show, Random& random) {
  return random.below(static_cast<std::uint32_t>(show.stage().people().size()));
}

Wished many_values(const Show& show, const Models&, Random& random) {
  app::Tuning tuning = show.stage().tuning();
  change_some_values(tuning, random);
  tuning.agents = std::min(tuning.agents, 600);
  tuning.inspection.freeze_camera = random.chance(0.2F);
  tuning.inspection.thresholds = random.chance(0.2F);
  tuning.inspection.figures_above_heads = random.chance(0.2F);
  tuning.inspection.split = static_cast<app::Split>(random.below(3));
  tuning.inspection.split_at = random.unit();
  return app::Apply{tuning};
}

Wished one_value(const Show& show, const Models&, Random& random) {
  app::Tuning tuning = show.stage().tuning();
  const std::span<const app::TuningValue> values = app::tuning_values();
  const app::TuningValue& value = values[random.below(static_cast<std::uint32_t>(values.size()))];
  value.read(tuning, any_text_of(value, random));
  tuning.agents = std::min(tuning.agents, 600);
  return app::Apply{tuning};
}

Wished select(const Show& show, const Models&, Random& random) {
  if (random.chance(0.5F)) return app::Select{any_agent(show, random)};
  const float x = static_cast<float>(show.view().width) * random.unit(),
              y = static_cast<float>(show.view().height) * random.unit();
  return app::Select{show.agent_at(x, y)};
}

Wished push(const Show& show, const Models&, Random& random) {
  const auto selected = show.stage().selected();
  if (selected && random.chance(0.3F)) return app::Push{*selected, render::forward(show.view().camera)};
  return app::Push{any_agent(show, random), {random.between(-1, 1), random.unit(), random.between(-1, 1)}};
}

Wished hold(const Show& show, const Models&, Random& random) {
  if (random.chance(0.3F)) return app::Hold{};
  return app::Hold{any_agent(show, random), random.between(-1, 10)};
}

Wished roles(const Show& show, const Models&, Random& random) {
  const app::CharacterNumber character = any_character(show, random);
  const app::CharacterSource& person = show.stage().people()[character];
  app::RoleClips clips = person.roles.clips;
  const auto count = static_cast<std::uint32_t>(person.clip_names.size());
  clips[random.below(app::role_count)] = static_cast<int>(random.below(count + 1)) - 1;
  return app::SetRoles{character, clips};
}

Wished share(const Show& show, const Models&, Random& random) {
  return app::SetShare{any_character(show, random), any_number(random, app::least_share, app::most_share)};
}

Wished bones(const Show& show, const Models&, Random& random) {
  const app::CharacterNumber character = any_character(show, random);
  const anim::Skeleton& skeleton = show.stage().people()[character].character->skeleton;
  const auto count = static_cast<std::uint32_t>(skeleton.bones.size());
  std::vector<int> parents;
  for (const auto& bone : skeleton.bones) parents.push_back(bone.parent);
  app::BoneLodChoice choice = app::present_bone_lod(count, skeleton.level_bone_counts);
  choice = app::with_bone_moved(parents, std::move(choice), random.below(count), random.below(count));
  return app::SetBones{character, choice};
}

Wished body(const Show& show, const Models&, Random& random) {
  const app::CharacterNumber character = any_character(show, random);
  const std::vector<std::string> keys = app::bone_keys(show.stage().people()[character].character->skeleton);
  std::vector<app::RigChoice> parts;
  for (std::uint32_t left = random.below(3); left > 0; --left) {
    parts.push_back({static_cast<anim::BodyRole>(random.below(anim::body_role_count)), any_of(random, keys)});
  }
  return app::SetBody{character, parts};
}

Wished back(const Show&, const Models&, Random& random) { return app::GoBack{random.below(2)}; }

Wished models(const Show&, const Models& all, Random& random) {
  std::vector<std::string> files;
  for (std::uint32_t left = 1 + random.below(3); left > 0; --left) files.push_back(any_model(all, random));
  return app::LoadModels{files};
}

Status fly(Show& show, Random& random) {
  show.view().camera.position = {random.between(-30, 30), random.between(0.2F, 20), random.between(-30, 30)};
  show.view().camera.yaw = random.between(-3, 3);
  show.view().camera.pitch = random.between(-1.5F, 0.5F);
  show.view().films = random.chance(0.3F);
  return Done{};
}

Status resize(Show& show, Random& random) {
  const int width = any_whole_number(random, 1, 900), height = any_whole_number(random, 1, 700);
  if (show.painter().draws()) {
    if (Status set = show.painter().renderer().set_size({width, height}); !set) return set;
  }
  show.view().width = width;
  show.view().height = height;
  return Done{};
}

Status draw(Show& show, Random& random) {
  if (!show.painter().draws()) return Done{};
  Status drawn = show.draw();
  if (drawn && random.chance(0.3F)) show.painter().renderer().read_image();
  return drawn;
}

Status reload_shaders(Show& show, Random&) {
  if (!show.painter().draws()) return Done{};
  return show.painter().renderer().reload_shaders();
}

constexpr Act acts[] = {
    {"fly", 6, fly}, {"resize", 4, resize}, {"draw", 10, draw}, {"reload shaders", 1, reload_shaders}};

constexpr Wish wishes[] = {{6, many_values}, {8, one_value}, {4, select}, {8, push}, {4, hold},  {2, roles},
                           {2, share},       {2, bones},     {2, body},   {3, back}, {3, models}};

template <typename Kind, std::size_t count>
constexpr std::uint32_t weight_of(const Kind (&kinds)[count]) {
  std::uint32_t all = 0;
  for (const Kind& kind : kinds) all += kind.weight;
  return all;
}

template <typename Kind, std::size_t count>
const Kind& any_kind(const Kind (&kinds)[count], Random& random) {
  std::uint32_t left = random.below(weight_of(kinds));
  const Kind* kind = std::begin(kinds);
  for (; left >= kind->weight; ++kind) left -= kind->weight;
  return *kind;
}

}  // namespace

void act_at_random(Show& show, const Models& models, Random& random, Counts& counts) {
  std::string words, name;
  Status done = Done{};
  if (random.below(weight_of(acts) + weight_of(wishes)) < weight_of(acts)) {
    const Act& act = any_kind(acts, random);
    words = name = act.name;
    done = act.run(show, random);
  } else {
    const Wished wished = any_kind(wishes, random).make(show, models, random);
    words = app::to_json(wished, show.stage().tuning()).dump();
    name = std::visit([](const auto& asked) { return std::string(asked.name); }, wished);
    done = show.take(wished);
  }
  tell("frame " + std::to_string(show.stage().posed().frame()) + ": " + words +
       (done ? "" : ": " + done.error().message));
  ++counts[name];
}

}  // namespace throng::soak
