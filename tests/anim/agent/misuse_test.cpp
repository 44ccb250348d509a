
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/agent/targeted_processes.h"
#include "engine/anim/asset/model_check.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/heard_misuses.h"

// Calls that break their contract: each is told of once, by name, and changes nothing.
namespace throng::anim::misuse_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Listens to misuses as long as a test runs.
class MisuseTest : public testing::Test {
 protected:
  std::vector<std::string>& heard = HeardMisuses::all();

  AnimationSystem& system() { return *crowd_.system; }
  Agent agent() { return system().agent(0); }

  /// Expects that a call is told of in one sentence, and that the crowd goes on as one that never heard it.
  void expect_ignored(const char* sentence, const std::function<void(AnimationSystem&)>& call) {
    heard.clear();
    CrowdRig misused = playing(), other = playing();
    call(*misused);
    EXPECT_THAT(heard, testing::ElementsAre(HasSubstr(sentence)));
    for (CrowdRig* crowd : {&misused, &other}) crowd->step(3);
    EXPECT_EQ(misused->figures().pose_hash(), other->figures().pose_hash()) << sentence;
  }

  static CrowdRig playing() {
    CrowdRig crowd({}, 4);
    for (std::uint32_t i = 0; i < 4; ++i) crowd->agent(i).play({.clip = static_cast<int>(i)});
    return crowd;
  }

 private:
  HeardMisuses listening_;
  CrowdRig crowd_ = playing();
};

TEST_F(MisuseTest, OfAnAgentThatIsNotThere) {
  for (const std::uint32_t number : {99U, 4'000'000'000U, no_number}) {
    expect_ignored("Agent::play", [&](auto& system) { EXPECT_FALSE(system.agent(number).play({.clip = 1})); });
    expect_ignored("Agent::set_speed", [&](auto& system) { EXPECT_FALSE(system.agent(number).set_speed(2.0)); });
    expect_ignored("Crowd::remove_agent", [&](auto& system) { EXPECT_FALSE(system.remove_agent({number})); });
    expect_ignored("Agent::add", [&](auto& system) {
      EXPECT_FALSE(system.agent(number).add_channel(std::make_unique<SimpleChannel>(PlayerStart{})));
    });
    expect_ignored("Agent::add", [&](auto& system) {
      EXPECT_FALSE(system.agent(number).add_post_process(std::make_unique<NoiseProcess>(NoiseProcess::Settings{})));
    });
  }
  EXPECT_THAT(system().agent(99).pose(), IsEmpty());
  EXPECT_EQ(system().agent(99).channel_count(), 0U);
  EXPECT_EQ(system().agent(99).motion().displacement(Ticks{}, ticks_per_second).translation, glm::dvec3(0.0));
}

TEST_F(MisuseTest, OfARequestThatIsNone) {
  const auto plays = [&](const char* sentence, const PlayRequest& request) {
    expect_ignored(sentence, [&](auto& system) { EXPECT_FALSE(system.agent(0).play(request)); });
  };
  plays("clip is not an index", {.clip = 999});
  plays("clip is not an index", {.clip = -1});
  plays("a speed is a number", {.clip = 1, .speed = nan});
  plays("a speed is a number", {.clip = 1, .speed = 40'000.0});
  plays("a speed is a number", {.clip = 1, .speed = -1e30});
  plays("held_fraction", {.clip = 1, .held_fraction = std::nanf("")});
  plays("held_fraction", {.clip = 1, .held_fraction = 5.0F});
  plays("from no time to a day", {.clip = 1, .fade = to_ticks(-1.0)});
  plays("mask is not", {.clip = 1, .mask = 7});
  plays("mask is not", {.clip = 1, .mask = -2});
  plays("bone_selection is not", {.clip = 1, .bone_selection = 7});
  plays("absolute root", {.clip = 1, .absolute_root = AbsoluteRoot{.position = {nan, 0.0, 0.0}}});
}

TEST_F(MisuseTest, OfAChannel) {
  expect_ignored("the channel is null",
                 [](auto& system) { EXPECT_FALSE(system.agent(0).add_channel(std::unique_ptr<SimpleChannel>())); });
  expect_ignored("clip is not an index", [](auto& system) {
    EXPECT_FALSE(system.agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 77})));
  });
  expect_ignored("mask is not", [](auto& system) {
    EXPECT_FALSE(system.agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{}), {.mask = 7}));
  });
  expect_ignored("a weight is from 0 to 1", [](auto& system) {
    EXPECT_FALSE(system.agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{}), {.weight = 5.0F}));
  });
  expect_ignored("no channel of this id", [](auto& system) { EXPECT_FALSE(system.agent(0).remove_channel({7})); });
  expect_ignored("no channel of this id",
                 [](auto& system) { EXPECT_FALSE(system.agent(0).set_channel_weight({5}, 1)); });
  expect_ignored("a weight is from 0 to 1",
                 [](auto& system) { EXPECT_FALSE(system.agent(0).set_channel_weight({0}, std::nanf(""))); });
  expect_ignored("no channel of this id and type", [](auto& system) {
    EXPECT_FALSE(system.agent(0).template change<BlendSpaceChannel>({0}, [](auto&) { FAIL() << "it is none"; }));
  });
}

TEST_F(MisuseTest, OfAPostProcess) {
  expect_ignored("the post process is null",
                 [](auto& system) { EXPECT_FALSE(system.agent(0).add_post_process(std::unique_ptr<NoiseProcess>())); });
  expect_ignored("was not added to this character", [](auto& system) {
    EXPECT_FALSE(system.agent(0).add_post_process(std::make_unique<LookAtProcess>(EntityPools::Kind{9})));
  });
  expect_ignored("was not added to this character", [](auto& system) {
    EXPECT_FALSE(system.agent(0).add_post_process(std::make_unique<LookAtProcess>(EntityPools::noise_makers)));
  });
  expect_ignored("no post process of this id",
                 [](auto& system) { EXPECT_FALSE(system.agent(0).remove_post_process({0})); });
  expect_ignored("no post process of this id and type", [](auto& system) {
    EXPECT_EQ(system.agent(0).template take_post_process<NoiseProcess>({0}), nullptr);
  });
  expect_ignored("no post process of this id and type", [](auto& system) {
    EXPECT_FALSE(system.agent(0).template change_process<NoiseProcess>({3}, [](auto&) { FAIL() << "there is none"; }));
  });
}

TEST_F(MisuseTest, OfAnUpdate) {
  const AlignedBytes memory = allocate_aligned(std::size_t{64} << 10U);
  const auto updates = [&](const char* sentence, const PoseRequest& update) {
    heard.clear();
    system().update({&update, 1});
    ASSERT_EQ(heard.size(), 1U) << sentence;
    EXPECT_THAT(heard.front(), HasSubstr(sentence));
    EXPECT_EQ(system().figures().report().agents_updated, 0U);
  };
  updates("an agent of this id is not in the system", {.agent = {99}});
  updates("an agent of this id is not in the system", {.agent = {0, 5}});
  updates("fewer bone levels", {.agent = {0}, .level = 9});
  updates("0 to 2 halves", {.agent = {0}, .fade_level = 3, .fade_halves = 3});
  updates("a multiple of 16 bytes", {.agent = {0}, .palette = memory.get() + 4});
  system().set_agent_count(5);
  updates("plays something", {.agent = {4}});
}

TEST_F(MisuseTest, OfAnAgentThatComesTwiceInAnUpdate) {
  const std::vector<PoseRequest> twice{{.agent = {0}}, {.agent = {1}}, {.agent = {0}}};
  system().update(twice);
  EXPECT_EQ(system().figures().report().agents_updated, 2U);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_THAT(heard.front(), HasSubstr("once in a call"));
}

TEST_F(MisuseTest, OfAnExactPose) {
  const auto poses = [&](const char* sentence, const ExactPose& pose) {
    heard.clear();
    system().pose_exactly({&pose, 1});
    ASSERT_EQ(heard.size(), 1U) << sentence;
    EXPECT_THAT(heard.front(), HasSubstr(sentence));
  };
  poses("neither a palette nor local transforms", {.agent = {0}});
  alignas(16) std::array<std::byte, 64> bytes{};
  poses("a multiple of 16 bytes", {.agent = {0}, .palette = reinterpret_cast<PaletteMatrix*>(bytes.data() + 4)});
  poses("an agent of this id is not in the system", {.agent = {99}});
}

TEST_F(MisuseTest, OfTime) {
  expect_ignored("time does not go back", [](auto& system) { system.advance(to_ticks(-1.0)); });
  const Ticks before = system().clock();
  system().advance(to_ticks(1e9));
  system().advance(to_ticks(9e9));
  EXPECT_EQ(system().clock(), before + to_ticks(1e9)) << "a hundred years are 3.2e9 s";
  const PoseRequest update{.agent = {0}};
  system().update({&update, 1});
}

TEST_F(MisuseTest, OfCharacters) {
  EXPECT_FALSE(AnimationSystem::create(nullptr, {}));
  EXPECT_FALSE(system().characters().add(nullptr));
  EXPECT_FALSE(system().characters().remove({3}));
  EXPECT_EQ(system().add_agents(1, 9).size(), 0U);
  const std::uint8_t numbers[] = {0, 200};
  EXPECT_EQ(system().add_agents(numbers).size(), 1U) << "up to the one that is not there";
  EXPECT_FALSE(system().set_agent_count(UINT32_MAX));
  EXPECT_EQ(heard.size(), 6U);
  EXPECT_EQ(system().characters()[7].skeleton.bone_count(), 0);
  EXPECT_EQ(system().agent_count(), 5U);
}

TEST_F(MisuseTest, OfTheSixteenthKindOfEntity) {
  static constexpr EntityKind kind{
      .name = "none", .advance = [](const EntityRun&) {}, .pose_whole = [](const EntityInStore&, const PoseView&) {}};
  EXPECT_FALSE(system().characters().add_entity_kind({.name = "poses nothing", .advance = [](const EntityRun&) {}}));
  for (auto i = EntityPools::usual_kinds + 0U; i < EntityPools::most_kinds; ++i) {
    EXPECT_TRUE(system().characters().add_entity_kind(kind));
  }
  EXPECT_FALSE(system().characters().add_entity_kind(kind));
  EXPECT_THAT(heard.back(), HasSubstr("at most 15 kinds"));
}

TEST_F(MisuseTest, OfACallWithinACall) {
  class Reentrant final : public Executor {
   public:
    AnimationSystem* system = nullptr;
    void run(int count, Job job) override {
      if (system != nullptr) {
        system->update({});
        EXPECT_FALSE(system->agent(0).play({.clip = 1}));
        EXPECT_FALSE(system->remove_agent({0}));
      }
      for (int index = 0; index < count; ++index) job.run(job.context, index);
    }
  } executor;
  CrowdRig crowd({.executor = &executor}, 1);
  crowd->agent(0).play({.clip = 2});
  executor.system = crowd.system.get();
  crowd.step();
  executor.system = nullptr;
  EXPECT_EQ(heard.size(), 3U);
  for (const std::string& each : heard) EXPECT_THAT(each, HasSubstr("in the middle of another call"));
}

TEST_F(MisuseTest, OfAnExecutor) {
  class Wild final : public Executor {
   public:
    std::vector<int> jobs;
    void run(int, Job job) override {
      for (const int index : jobs) job.run(job.context, index);
    }
  } executor;
  CrowdRig crowd({.executor = &executor}, 1);
  crowd->agent(0).play({.clip = 2});
  crowd.step();
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_THAT(heard.front(), HasSubstr("each of its jobs before it returns"));
  executor.jobs = {0, 0, 77, -3};
  crowd.step();
  EXPECT_EQ(heard.size(), 4U) << "the second 0, 77 and -3";
}

/// A fault, and what the check says of it.
struct Spoiled {
  const char* sentence;
  std::function<void(Model&)> spoil;
};

/// Expects that a model is whole, and is refused in words once each fault alone has spoiled it.
void expect_refusals(const Model& whole, std::span<const Spoiled> cases) {
  ASSERT_TRUE(check_model(whole));
  for (const Spoiled& each : cases) {
    Model model = whole;
    each.spoil(model);
    const Status checked = check_model(model);
    ASSERT_FALSE(checked) << each.sentence;
    EXPECT_THAT(checked.error().message, HasSubstr(each.sentence));
  }
}

TEST(ModelCheck, NamesTheFaultAndWhereItIs) {
  const Spoiled cases[] = {
      {"it has no bones", [](Model& model) { model.skeleton = {}; }},
      {"its parent is not a bone before it", [](Model& model) { model.skeleton.bones[3].parent = 7; }},
      {"its parent is not a bone before it", [](Model& model) { model.skeleton.bones[3].parent = 700; }},
      {"more than 1024", [](Model& model) { model.skeleton.bones.resize(1025); }},
      {"one reference a bone", [](Model& model) { model.skeleton.references.clear(); }},
      {"it has no palette", [](Model& model) { model.skeleton.palette.clear(); }},
      {"no levels", [](Model& model) { model.skeleton.level_bone_counts.clear(); }},
      {"its first level", [](Model& model) { model.skeleton.level_bone_counts = {5}; }},
      {"do not ascend by bones", [](Model& model) { model.clips[0].tracks[0].bone = 99; }},
      {"do not ascend by bones", [](Model& model) { model.clips[0].tracks.push_back(model.clips[0].tracks[0]); }},
      {"one value a key", [](Model& model) { model.clips[0].tracks[0].rotation.values.pop_back(); }},
      {"a key's value is not finite",
       [](Model& model) { model.clips[0].tracks[0].rotation.values[1].x = std::nanf(""); }},
      {"a rotation is zero", [](Model& model) { model.clips[0].tracks[0].rotation.values[1] = glm::quat(0, 0, 0, 0); }},
      {"do not ascend", [](Model& model) { std::ranges::reverse(model.clips[0].tracks[0].rotation.times); }},
      {"ends before a key", [](Model& model) { model.clips[0].duration /= 4.0; }},
      {"its start and duration", [](Model& model) { model.clips[0].duration = -1.0; }},
      {"its start and duration", [](Model& model) { model.clips[0].duration = nan; }},
      {"data key", [](Model& model) { model.clips[0].data_keys = {{.time = 55.0, .name = "x"}}; }},
  };
  expect_refusals(synthetic_model(20, 1), cases);
}

TEST(ModelCheck, NamesNumbersThatAreNone) {
  Model model = synthetic_model(20, 1);
  model.clips[0].curves = {{.name = "glow", .times = {0.0F, 1.0F}, .values = {0.0F, 8.0F}}};
  const Spoiled cases[] = {
      {"its rest transform is not of finite", [](Model& model) { model.skeleton.bones[3].rest.scale.y = INFINITY; }},
      {"a key's time is negative or not finite", [](Model& model) { model.clips[0].tracks[0].rotation.times[0] = -1; }},
      {"a key's time is negative or not finite",
       [](Model& model) { model.clips[0].tracks[0].rotation.times[1] = std::nanf(""); }},
      {"curve \"glow\": it does not have one value a time",
       [](Model& model) { model.clips[0].curves[0].values = {1}; }},
      {"curve \"glow\": its times do not ascend", [](Model& model) { model.clips[0].curves[0].times[1] = 0.0F; }},
      {"curve \"glow\": its times do not ascend, or a number is not finite",
       [](Model& model) { model.clips[0].curves[0].values[1] = std::nanf(""); }},
      {"two curves \"glow\"", [](Model& model) { model.clips[0].curves.push_back(model.clips[0].curves[0]); }},
  };
  expect_refusals(model, cases);
}

TEST(ModelCheck, NamesTheFaultOfASurface) {
  Model model = synthetic_model(20, 1);
  SkinnedMesh& mesh = model.meshes.emplace_back();
  mesh.positions.resize(3);
  mesh.palette_entries.resize(3);
  mesh.weights.resize(3);
  mesh.indices = {0, 1, 2};
  const Spoiled cases[] = {
      {"one weight and one palette entry a position", [](Model& model) { model.meshes[0].weights.pop_back(); }},
      {"not triangles of its positions", [](Model& model) { model.meshes[0].indices[2] = 3; }},
      {"not triangles of its positions", [](Model& model) { model.meshes[0].indices.pop_back(); }},
      {"a vertex is not of finite numbers", [](Model& model) { model.meshes[0].positions[1].y = std::nanf(""); }},
      {"a vertex is not of finite numbers", [](Model& model) { model.meshes[0].weights[1].x = std::nanf(""); }},
      {"reads beyond the palette", [](Model& model) { model.meshes[0].palette_entries[2].w = 20; }},
  };
  expect_refusals(model, cases);
}

TEST_F(MisuseTest, OfAModelGivesACharacterThatNoSystemTakes) {
  Model model = synthetic_model(20, 1);
  model.skeleton.bones[3].parent = 7;
  const auto character = std::make_shared<const Character>(bake_character(model));
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_THAT(heard.front(), HasSubstr("its parent is not a bone before it"));
  EXPECT_FALSE(AnimationSystem::create(character, {}));
}

}  // namespace
}  // namespace throng::anim::misuse_test
