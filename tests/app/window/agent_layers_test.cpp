#include "app/window/agent_layers.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/character/source.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/agent/targeted_processes.h"

namespace throng::app::agent_layers_test {
namespace {

/// One mannequin, posed by nothing but a clip on its first channel.
struct LayeredAgent : testing::Test {
  LayeredAgent()
      : source(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin")),
        rigs(source.model),
        system(std::move(*anim::AnimationSystem::create(source.character, {}))) {
    kinds = rigs.add_to(*system, 0);
    system->set_agent_count(1);
    system->agent(0).play({.clip = 0});
  }
  void pass(int frames) {
    for (int i = 0; i < frames; ++i) {
      system->advance(ticks_per_second / 60);
      system->update(std::vector<PoseRequest>{{.agent = {0}}});
    }
  }
  std::vector<LayerRow> layers() const { return agent_layers(*system, 0); }
  std::string kind_of(std::size_t step) const {
    return system->agent(0).pools().kind(system->agent(0).graph().entities[step]).name;
  }

  CharacterSource source;
  anim::CharacterRigs rigs;
  std::unique_ptr<anim::AnimationSystem> system;
  anim::RigKinds kinds;
};

TEST_F(LayeredAgent, OfOneClipHasOneChannelOfOnePlayer) {
  pass(1);
  ASSERT_EQ(layers().size(), 1U);
  EXPECT_EQ(layers()[0].weight, 1);
  EXPECT_TRUE(layers()[0].is_channel);
  EXPECT_EQ(layers()[0].entities, std::vector<std::size_t>{0});
}

TEST_F(LayeredAgent, ThatFadesHasBothClipsInTheSameChannel) {
  pass(1);
  system->agent(0).play({.clip = 1, .fade = ticks_per_second});
  pass(1);
  ASSERT_EQ(layers().size(), 1U);
  EXPECT_EQ(layers()[0].entities.size(), 3U) << "two players and their blender";
  EXPECT_EQ(kind_of(layers()[0].entities.back()), "ease blender") << "sources first";
}

TEST_F(LayeredAgent, TellsOfEachChannelHowMuchOfItIsLaidOverThoseBefore) {
  const int mask =
      system->characters().add_mask({"arm", source.character->skeleton, std::vector<anim::SubtreeWeight>{{.bone = 5}}});
  ASSERT_TRUE(system->agent(0).add_channel(std::make_unique<anim::SimpleChannel>(anim::PlayerStart{.clip = 1}),
                                           {.weight = 0.25F}));
  ASSERT_TRUE(system->agent(0).add_channel(std::make_unique<anim::SimpleChannel>(anim::PlayerStart{.clip = 2}),
                                           {.weight = 0.5F, .mask = mask}));
  pass(1);
  const std::vector<LayerRow> all = layers();
  ASSERT_EQ(all.size(), 3U) << "blenders that lay channels over each other are no layers of their own";
  EXPECT_EQ(all[0].weight, 1);
  EXPECT_EQ(all[1].weight, 0.25F);
  EXPECT_FALSE(all[1].is_masked);
  EXPECT_EQ(all[2].weight, 0.5F);
  EXPECT_TRUE(all[2].is_masked);
  for (const LayerRow& layer : all) EXPECT_EQ(layer.entities.size(), 1U);
  system->agent(0).set_channel_weight({1}, 0.75F);
  EXPECT_EQ(layers()[1].weight, 0.75F);
}

TEST_F(LayeredAgent, TellsOfWhatChangesThePoseHowMuchOfItIsApplied) {
  ASSERT_TRUE(kinds.look_at);
  ASSERT_TRUE(system->agent(0).add_post_process(std::make_unique<anim::LookAtProcess>(*kinds.look_at)));
  pass(1);
  ASSERT_EQ(layers().size(), 2U);
  EXPECT_FALSE(layers()[1].is_channel);
  EXPECT_EQ(layers()[1].name, "look-at");
  EXPECT_EQ(layers()[1].weight, 0) << "it looks nowhere yet, though all of the pose passes through it";
  ASSERT_TRUE(system->agent(0).change_process<anim::LookAtProcess>({0}, [](auto& look) {
    look.look_at({1.0F, 1.0F, 1.0F});
  }));
  pass(1);
  EXPECT_EQ(layers()[1].weight, 1);
}

}  // namespace
}  // namespace throng::app::agent_layers_test
