#include "tests/anim/agent/held_crowd.h"

#include <memory>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/one_entity_process.h"
#include "engine/anim/agent/targeted_processes.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/base/elementary.h"
#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

constexpr std::uint32_t held_agents = 120;
constexpr int held_frames = 20;

const Model& model() {
  static const Model made = synthetic_model(62, 2);
  return made;
}
const CharacterRigs& rigs() {
  static const CharacterRigs made(model());
  return made;
}
std::shared_ptr<const Character> held_character() {
  static const auto made = std::make_shared<const Character>(bake_character(model()));
  return made;
}

void add_gaze(AnimationSystem& system, const RigKinds& kinds, std::uint32_t agent) {
  auto gaze = std::make_unique<LookAtProcess>(*kinds.look_at);
  gaze->look_at({sine(static_cast<float>(agent)), 1.4F, 1.5F}, agent * ticks_per_second / 100);
  EXPECT_TRUE(system.agent(agent).add_post_process(std::move(gaze)));
}

void add_noise(AnimationSystem& system, std::uint32_t agent) {
  const NoiseProcess::Settings settings{.frequency = 2.0F, .amplitude = 0.05F, .seed = agent};
  EXPECT_TRUE(system.agent(agent).add_post_process(std::make_unique<NoiseProcess>(settings)));
}

/// A host's kind that moves no bone, and turns the first by where all of them are: where no clip displaces one it has
/// to find 0, whatever the local store held before.
struct alignas(64) Wanderer {
  AnimationStateHeader state;
  Handle source;
};
static_assert(sizeof(Wanderer) == entity_header_bytes);

std::span<Handle> source_of_wanderer(std::byte* block, const EntityLayout&) {
  return {&reinterpret_cast<Wanderer*>(block)->source, 1};
}

void advance_wanderer(const EntityInStore& entity, const SourcesInStore&) {
  entity.as<Wanderer>().state.delta_time = Ticks{};
}

void turn_by_positions(const EntityInStore&, const PoseView& pose) {
  float far = 0.0F;
  for (int bone = 0; bone < pose.bone_count; ++bone) far += pose.position(bone).x + pose.position(bone).z;
  pose.set_rotation(0, pose.rotation(0) * angle_axis(far, glm::vec3(0.0F, 1.0F, 0.0F)));
}

const EntityKind wanderer_kind = {.name = "wanderer",
                                  .sources = source_of_wanderer,
                                  .advance = advance_each<advance_wanderer>,
                                  .pose_whole = turn_by_positions,
                                  .displaced_quads = 0};

/// The same, but its pose is state of its own: not changed where it lies, and brought to memory with all positions.
EntityKind keeping(EntityKind kind) {
  kind.keeps_transforms = true;
  return kind;
}
const EntityKind keeping_wanderer_kind = keeping(wanderer_kind);

class WandererProcess final : public OneEntityProcess<Wanderer> {
 public:
  explicit WandererProcess(EntityPools::Kind kind) : OneEntityProcess(kind) {}
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<WandererProcess>(*this); }

 private:
  void begin(const EntityBuilder&, Handle) override {}
};

void add_wanderer(AnimationSystem& system, EntityPools::Kind kind, std::uint32_t agent) {
  EXPECT_TRUE(system.agent(agent).add_post_process(std::make_unique<WandererProcess>(kind)));
}

}  // namespace

std::uint64_t hash_of_held_crowd(const SystemOptions& options) {
  auto created = AnimationSystem::create(held_character(), options);
  if (!created) {
    ADD_FAILURE() << created.error().message;
    return 0;
  }
  AnimationSystem& system = **created;
  const RigKinds kinds = rigs().add_to(system);
  const EntityPools::Kind wanderers = *system.characters().add_entity_kind(wanderer_kind);
  const EntityPools::Kind keepers = *system.characters().add_entity_kind(keeping_wanderer_kind);
  system.set_agent_count(held_agents);
  for (std::uint32_t agent = 0; agent < held_agents; ++agent) {
    system.agent(agent).play({.clip = 0, .start = agent * ticks_per_second / 60});
    if (agent % 2 == 0) system.agent(agent).play({.clip = 1, .held_fraction = 0.3F});
    if (agent % 5 == 1) add_noise(system, agent);
    if (agent % 5 > 1) add_gaze(system, kinds, agent);
    if (agent % 5 == 3) add_noise(system, agent);
    if (agent % 5 == 1 && agent % 3 == 1) add_gaze(system, kinds, agent);
    if (agent % 5 == 4) add_wanderer(system, agent % 2 == 0 ? wanderers : keepers, agent);
  }
  std::vector<PoseRequest> updates;
  for (int frame = 0; frame < held_frames; ++frame) {
    updates.clear();
    for (std::uint32_t agent = 0; agent < held_agents; ++agent) {
      updates.push_back({.agent = {agent}, .level = static_cast<std::uint8_t>(agent % 7 == 0 ? 2 : agent % 11 == 0)});
    }
    system.advance(ticks_per_second / 60);
    system.update(updates);
  }
  return system.figures().pose_hash();
}

}  // namespace throng::anim
