#include "tests/anim/agent/every_kind.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/entity/additive_layer.h"
#include "engine/anim/entity/entity_run.h"
#include "engine/anim/entity/held_state.h"
#include "engine/anim/entity/mixer.h"

namespace throng::anim {
namespace {

/// Kinds of the host's own: what bones turn by grows with time; the one poses packets, the other whole poses.
struct alignas(64) Drift {
  AnimationStateHeader state;
  Ticks time;
  Handle source;
};
static_assert(sizeof(Drift) == entity_header_bytes);

float drifted(const Drift& drift) { return static_cast<float>(std::fmod(to_seconds(drift.time), 1.0)) * 0.2F; }

void advance_drift(const EntityInStore& entity, const SourcesInStore&) {
  auto& drift = entity.as<Drift>();
  drift.time += drift.state.delta_time;
  drift.state.delta_time = Ticks{};
}

void drift_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& drift = entity.as<Drift>();
  std::fill_n(job.out, entity.assets->components * packet_bones, 0.0F);
  std::fill_n(job.out + 3 * packet_bones, packet_bones, 1.0F);
  std::fill_n(job.out + 4 * packet_bones, packet_bones, drifted(drift));
}

std::span<Handle> drift_source(std::byte* block, const EntityLayout&) {
  return {&reinterpret_cast<Drift*>(block)->source, 1};
}

/// Reads bones of several packets at once: the first and the last there is.
void drift_whole(const EntityInStore& entity, const PoseView& pose) {
  pose.set_position(0, pose.position(0) + drifted(entity.as<Drift>()) * pose.position(pose.bone_count - 1));
  pose.set_rotation(pose.bone_count - 1, pose.rotation(0));
}

const EntityKind drift_kind = {.name = "drift", .advance = advance_each<advance_drift>, .pose_packet = drift_packet};
const EntityKind whole_drift_kind = {
    .name = "whole drift", .sources = drift_source, .advance = advance_each<advance_drift>, .pose_whole = drift_whole};

class DriftProcess final : public PostProcess {
 public:
  explicit DriftProcess(EntityPools::Kind kind) : kind_(kind) {}
  Handle attach(const EntityBuilder& build, Handle source) override {
    if (!entity_.valid()) entity_ = build.create(kind_);
    build.as<Drift>(entity_).source = source;
    return entity_;
  }
  void visit_handles(const std::function<void(Handle&)>& visit) override { visit(entity_); }
  void destroy_entities(const EntityBuilder& build) override { build.destroy(entity_); }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<DriftProcess>(*this); }

 private:
  EntityPools::Kind kind_;
  Handle entity_;
};

std::vector<Handle> mixed(const EntityBuilder& build, Handle shared) {
  const Handle one = build.player({.clip = 0, .speed = 0.7});
  const Handle other = build.player({.clip = 1, .speed = -1.0});
  const Handle mixer = build.create(EntityPools::mixers);
  build.as<Mixer>(mixer).source_count = 4;
  std::ranges::fill(build.as<Mixer>(mixer).masks, EaseBlender::no_mask);
  MixerSources& sources = mixer_sources(build.pools().block(mixer), build.pools().layout(mixer));
  std::ranges::copy(std::array{one, other, shared, one}, sources.sources);
  std::ranges::copy(std::array{1.0F, 0.5F, 2.0F, 0.25F}, sources.weights);
  return {one, other, mixer};
}

std::vector<Handle> leaning(const EntityBuilder& build) {
  const Handle reference = build.create(EntityPools::held_states);
  const Handle base = build.player({.clip = 2});
  const Handle layer = build.player({.clip = 3, .speed = 1.3});
  const Handle additive = build.create(EntityPools::additive_layers);
  auto& lean = build.as<AdditiveLayer>(additive);
  lean.base = base;
  lean.layer = layer;
  lean.reference = reference;
  lean.target_weight = 0.8F;
  lean.weight_per_second = 0.5F;
  lean.mask = 1;
  return {reference, base, layer, additive};
}

std::vector<Handle> drifting(const EntityBuilder& build, EntityPools::Kind kind, Handle shared) {
  const Handle drift = build.create(kind);
  build.as<Drift>(drift).time = build.now() + build.lead();
  return {drift, build.ease(shared, drift, 3 * ticks_per_second)};
}

void expect_done(const Status& status) { EXPECT_TRUE(status) << status.error().message; }

}  // namespace

EveryKind::EveryKind(const SystemOptions& options) {
  auto created = AnimationSystem::create(test_character(), options);
  EXPECT_TRUE(created.has_value()) << created.error().message;
  system = std::move(*created);
  system->set_agent_count(agents);
  const EntityPools::Kind drifts = *system->characters().add_entity_kind(drift_kind);
  const EntityPools::Kind whole_drifts = *system->characters().add_entity_kind(whole_drift_kind);
  for (const int bone : {1, 5}) {
    const SubtreeWeight subtree{.bone = bone, .weight = 0.75F};
    system->characters().add_mask(BoneMask("part", test_character()->skeleton, {&subtree, 1}));
  }
  const auto fixed = [](FixedChannel::Make make) { return std::make_unique<FixedChannel>(std::move(make)); };
  const Handle breath =
      *system->characters().add_shared(std::make_unique<SimpleChannel>(PlayerStart{.clip = 4, .speed = 0.5}));
  const Handle stance = *system->characters().add_shared(fixed([breath](const EntityBuilder& build) {
    const Handle player = build.player({.clip = 3});
    return std::vector{player, build.hold(player, breath, 0.5F)};
  }));
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    switch (agent % 8) {
      case 0:
        expect_done(
            system->agent(agent).add_channel(fixed([=](const EntityBuilder& build) { return mixed(build, stance); })));
        break;
      case 1:
        expect_done(system->agent(agent).add_channel(fixed(leaning)));
        break;
      case 2:
        expect_done(system->agent(agent).add_channel(
            fixed([=](const EntityBuilder& build) { return drifting(build, drifts, breath); })));
        break;
      case 3:
        expect_done(system->agent(agent).add_channel(std::make_unique<BlendSpaceChannel>(
            std::vector<BlendPoint>{{.clip = 4, .parameter = 1.0F}, {.clip = 0, .parameter = 3.0F}}, 1.0F, true)));
        break;
      default:
        system->agent(agent).play({.clip = static_cast<int>(agent % 5)});
    }
    if (agent % 3 == 0) {
      expect_done(system->agent(agent).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}),
                                                   {.weight = 0.4F, .mask = 0}));
    }
    if (agent % 5 == 0)
      expect_done(
          system->agent(agent).add_post_process(std::make_unique<NoiseProcess>(NoiseProcess::Settings{.seed = agent})));
    if (agent % 7 == 0)
      expect_done(system->agent(agent).add_post_process(std::make_unique<DriftProcess>(whole_drifts)));
  }
}

void EveryKind::request(std::uint32_t agent, std::uint32_t frame) {
  const std::uint32_t mixed = (agent * 2654435761U + frame * 40503U) >> 4U;
  if (agent % 8 == 3 && (agent + frame) % 5 == 0) {
    expect_done(system->agent(agent).change<BlendSpaceChannel>({0}, [&](BlendSpaceChannel& channel) {
      channel.set_parameter(static_cast<float>(mixed % 300U) * 0.01F + 0.5F);
    }));
  } else if (agent % 8 > 3 && (agent + frame) % 9 == 0) {
    system->agent(agent).play({.clip = static_cast<int>(mixed % 5U),
                               .fade = to_ticks(0.1 + 0.02 * (mixed % 13U)),
                               .speed = 0.6 + 0.05 * (mixed % 17U)});
  }
}

void EveryKind::step(int frames) {
  const auto levels = static_cast<std::uint32_t>(test_character()->skeleton.level_bone_counts.size());
  std::vector<PoseRequest> updates;
  for (int i = 0; i < frames; ++i) {
    system->advance(frame_ticks);
    const auto frame = static_cast<std::uint32_t>(system->clock() / frame_ticks);
    updates.clear();
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      request(agent, frame);
      const bool skips = agent % 3 == 1;
      if (skips && frame % 2 == 0) continue;
      updates.push_back({.agent = {agent},
                         .level = static_cast<std::uint8_t>((agent / 8 + frame / 64) % levels),
                         .look_ahead = skips ? 2 * frame_ticks : Ticks{}});
    }
    system->update(updates);
  }
}

}  // namespace throng::anim
