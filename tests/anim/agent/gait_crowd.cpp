#include "tests/anim/agent/gait_crowd.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {
namespace {

void travel(BakedClip& clip, const glm::dvec3& metres_a_second) {
  clip.loop_displacement = metres_a_second * to_seconds(clip.duration);
  clip.root_motion = straight_root_curve(clip.duration, clip.loop_displacement);
}

Character make_character() {
  Model model = synthetic_model(20, 8);
  const auto keys = [&](int clip) -> std::vector<NamedDataKey>& {
    return model.clips[static_cast<std::size_t>(clip)].data_keys;
  };
  const std::string left = "footstep_left", right = "footstep_right";
  keys(gaits::idle) = {{0.4, "breathe"}};
  keys(gaits::walk) = {{0.1, left}, {0.5, right}};
  keys(gaits::jog) = {{0.2, right}, {0.8, left}};
  keys(gaits::run) = {{0.05, left}, {0.6, right}};
  keys(gaits::aside) = {{0.1, left}, {0.5, right}};
  keys(gaits::gallop) = {{0.1, left}, {0.2, left}, {0.5, right}};
  keys(gaits::wave) = {{0.3, "hit"}};
  Character character = bake_character(model);
  travel(character.clips[gaits::walk], {0.0, 0.0, gaits::walk_speed});
  travel(character.clips[gaits::jog], {0.0, 0.0, gaits::jog_speed});
  travel(character.clips[gaits::run], {0.0, 0.0, gaits::run_speed});
  travel(character.clips[gaits::aside], {gaits::walk_speed, 0.0, 0.0});
  travel(character.clips[gaits::gallop], {0.0, 0.0, 3.0});
  BakedClip& bend = character.clips[gaits::bend];
  bend.root_motion =
      steady_root_curve(bend.duration, {.linear = {0.0, 0.0, gaits::walk_speed}, .yaw = 0.5 * std::numbers::pi});
  bend.loop_displacement = whole_motion(bend.root_motion).translation;
  return character;
}

}  // namespace

std::shared_ptr<const Character> gait_character() {
  static const auto character = std::make_shared<const Character>(make_character());
  return character;
}

GaitCrowd::GaitCrowd(std::uint32_t agents) {
  auto created = AnimationSystem::create(gait_character(), {});
  EXPECT_TRUE(created.has_value()) << created.error().message;
  system = std::move(*created);
  system->set_agent_count(agents);
}

Ticks GaitCrowd::step(Ticks by) {
  const Ticks before = system->clock();
  const PoseRequest update{.agent = {0}};
  system->advance(by);
  system->update({&update, 1});
  return before;
}

std::vector<const Player*> GaitCrowd::players() const {
  const AgentView agent = std::as_const(*system).agent(0);
  std::vector<const Player*> players;
  for (const Handle entity : agent.graph().entities) {
    const EntityType type = agent.pools().state(entity).type;
    if (type == EntityType::sampled_player || type == EntityType::keyframe_player) {
      players.push_back(&agent.pools().as<Player>(entity));
    }
  }
  return players;
}

const Player* GaitCrowd::player_of(int clip) const {
  for (const Player* player : players()) {
    if (player->clip == static_cast<std::uint32_t>(clip)) return player;
  }
  return nullptr;
}

std::vector<DataKeyEvent> GaitCrowd::keys(Ticks from, KeyChoice choice) const {
  std::vector<DataKeyEvent> events;
  const AgentMotion motion = std::as_const(*system).agent(0).motion();
  motion.for_each_data_key(
      from, system->clock(), [&](const DataKeyEvent& event) { events.push_back(event); }, choice);
  return events;
}

const std::string& GaitCrowd::name(const DataKeyEvent& event) const {
  return gait_character()->data_key_names[event.name];
}

double phase(const Player& player) {
  const auto length = static_cast<double>(gait_character()->clips[player.clip].duration * fine_ticks_per_tick);
  const double loops = static_cast<double>(player.position) / length;
  return loops - std::floor(loops);
}

}  // namespace throng::anim
