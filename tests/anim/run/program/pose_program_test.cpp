#include "engine/anim/run/program/pose_program.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/entity/mixer.h"
#include "engine/anim/entity/noise_maker.h"
#include "engine/anim/run/program/program_table.h"
#include "tests/anim/entity/entity_rig.h"

namespace throng::anim::pose_program_test {
namespace {

using testing::HasSubstr;

/// A graph in transient blocks, as `fused` has it: poses live in registers.
struct Graph {
  explicit Graph(Residency residency = Residency::transient) : pools(20, rigid_components, residency) {}

  Handle player(std::uint32_t owner = 0) {
    const Handle entity = pools.create(EntityPools::sampled_players);
    pools.state(entity).owner = owner;
    return entity;
  }
  Handle shared_player() {
    const Handle entity = pools.create(EntityPools::sampled_players, true);
    pools.state(entity).owner = shared_owner;
    return entity;
  }
  Handle blend(Handle from, Handle to) {
    const Handle entity = pools.create(EntityPools::ease_blenders);
    pools.as<EaseBlender>(entity).from = from;
    pools.as<EaseBlender>(entity).to = to;
    return entity;
  }
  Handle mix(std::initializer_list<Handle> sources) {
    const Handle entity = pools.create(EntityPools::mixers);
    pools.as<Mixer>(entity).source_count = static_cast<std::uint32_t>(sources.size());
    std::ranges::copy(sources, mixer_sources(pools.block(entity), pools.layout(entity)).sources);
    return entity;
  }
  Handle shaken(Handle source) {
    const Handle entity = pools.create(EntityPools::noise_makers);
    pools.as<NoiseMaker>(entity).source = source;
    return entity;
  }
  PoseGraph graph_of(Handle root) {
    PoseGraph graph;
    const Status status = compile_graph(pools, root, 0, programs, graph);
    EXPECT_TRUE(status) << status.error().message;
    return graph;
  }
  const PoseProgram& compiled(Handle root) { return *graph_of(root).program; }
  std::string refusal(Handle root) {
    PoseGraph graph;
    const Status status = compile_graph(pools, root, 0, programs, graph);
    return status ? "" : status.error().message;
  }
  int priority(Handle entity) const { return pools.state(entity).priority; }

  EntityPools pools;
  ProgramTable programs;
};

/// Each register holds what a step reads until the step has read it.
void expect_registers_hold(const PoseProgram& program) {
  std::array<int, PoseProgram::max_steps> written_by{};
  for (std::size_t i = 0; i < program.steps.size(); ++i) {
    const PoseStep& step = program.steps[i];
    for (std::size_t k = 0; k < step.source_count; ++k) {
      const std::size_t source = step.sources[k];
      ASSERT_LT(source, i) << "sources come first";
      EXPECT_EQ(written_by[program.steps[source].target], source) << "overwritten before step " << i << " read it";
    }
    EXPECT_LT(step.target, program.needs.registers);
    written_by[step.target] = static_cast<int>(i);
  }
}

TEST(PoseProgram, OfAPlayerAloneIsOneStep) {
  Graph graph;
  const Handle player = graph.player();
  const PoseGraph made = graph.graph_of(player);
  const PoseProgram& program = *made.program;
  ASSERT_EQ(program.steps.size(), 1U);
  EXPECT_EQ(made.root(), player);
  EXPECT_EQ(program.needs.registers, 1U);
  EXPECT_EQ(program.needs.shared, 0U);
}

TEST(PoseProgram, GivesAnEntityThePriorityBelowTheLowestOfItsSources) {
  Graph graph;
  const Handle player = graph.player();
  const Handle one_deep = graph.blend(graph.player(), graph.player());
  const Handle two_deep = graph.blend(one_deep, player);
  const Handle also_two_deep = graph.blend(player, one_deep);
  graph.compiled(graph.blend(two_deep, also_two_deep));
  EXPECT_EQ(graph.priority(player), highest_priority);
  EXPECT_EQ(graph.priority(one_deep), highest_priority - 1);
  EXPECT_EQ(graph.priority(two_deep), highest_priority - 2);
  EXPECT_EQ(graph.priority(also_two_deep), highest_priority - 2);
}

TEST(PoseProgram, EvaluatesASourceOfSeveralEntitiesOnce) {
  Graph graph;
  const Handle top = graph.player();
  const Handle left = graph.shaken(top);
  const Handle right = graph.shaken(top);
  const PoseProgram& diamond = graph.compiled(graph.blend(left, right));
  EXPECT_EQ(diamond.steps.size(), 4U);
  expect_registers_hold(diamond);
}

TEST(PoseProgram, OfAChainOfAnyDepthTakesTwoRegisters) {
  Graph graph;
  Handle root = graph.player();
  for (int depth = 0; depth < 30; ++depth) root = graph.blend(root, graph.player());
  const PoseProgram& program = graph.compiled(root);
  EXPECT_EQ(program.steps.size(), 61U);
  EXPECT_EQ(program.needs.registers, 2U) << "registers are given back after their last reader";
  expect_registers_hold(program);
}

TEST(PoseProgram, OfABalancedTreeTakesOneRegisterALevel) {
  Graph graph;
  const auto tree = [&](const auto& self, int depth) -> Handle {
    return depth == 0 ? graph.player() : graph.blend(self(self, depth - 1), self(self, depth - 1));
  };
  const PoseProgram& program = graph.compiled(tree(tree, 5));
  EXPECT_EQ(program.steps.size(), 63U);
  EXPECT_EQ(program.needs.registers, 6U);
  expect_registers_hold(program);
}

TEST(PoseProgram, OfManySourcesInAnyShapeKeepsWhatIsStillRead) {
  Graph graph;
  const Handle a = graph.player();
  const Handle b = graph.player();
  const Handle c = graph.player();
  const Handle ab = graph.blend(a, b);
  const Handle mixed = graph.mix({a, ab, c, graph.shaken(ab), b});
  const PoseProgram& program = graph.compiled(graph.blend(mixed, graph.blend(a, mixed)));
  EXPECT_EQ(program.steps.size(), 8U);
  expect_registers_hold(program);
}

TEST(PoseProgram, NeedsNoRegisterForABlockThatKeepsItsTransforms) {
  Graph graph;
  const Handle held = graph.pools.create(EntityPools::held_states);
  const PoseProgram& program = graph.compiled(graph.blend(held, graph.player()));
  EXPECT_EQ(program.needs.registers, 1U);
}

TEST(PoseProgram, KnowsHowMuchOfItsOwnLiesBeforeTheTailThatChangesThePoseInPlace) {
  Graph graph;
  const Handle player = graph.player();
  const Handle blender = graph.blend(player, graph.shared_player());
  const PoseProgram& program = graph.compiled(graph.shaken(graph.shaken(blender)));
  const EntityLayout& of_player = graph.pools.layout(player);
  EXPECT_EQ(program.tail, 3);
  EXPECT_EQ(program.blocks_before_tail, of_player.total_size + graph.pools.layout(blender).total_size);
  EXPECT_EQ(program.prepared_before_tail, of_player.kind->prepared_bytes);
}

TEST(PoseProgram, ReadsASharedEntityAndNothingBelowIt) {
  Graph graph;
  const Handle shared = graph.shared_player();
  const PoseProgram& program = graph.compiled(graph.blend(shared, graph.player()));
  ASSERT_EQ(program.steps.size(), 3U);
  EXPECT_TRUE(program.steps[0].is_shared());
  EXPECT_EQ(program.needs.shared, 1U);
}

TEST(PoseProgram, RefusesACycleAndNamesTheKind) {
  Graph graph;
  const Handle outer = graph.blend({}, graph.player());
  const Handle inner = graph.shaken(outer);
  graph.pools.as<EaseBlender>(outer).from = inner;
  EXPECT_THAT(graph.refusal(outer), HasSubstr("the ease blender 0 is among its own sources"));
  EXPECT_THAT(graph.refusal(inner), HasSubstr("the noise maker 0 is among its own sources"));
}

TEST(PoseProgram, RefusesAnEntityThatReadsItself) {
  Graph graph;
  const Handle blender = graph.blend({}, graph.player());
  graph.pools.as<EaseBlender>(blender).from = blender;
  EXPECT_THAT(graph.refusal(blender), HasSubstr("among its own sources"));
}

TEST(PoseProgram, RefusesAHandleToNothing) {
  Graph graph;
  const Handle dead = graph.player();
  const Handle blender = graph.blend(dead, graph.player());
  graph.pools.destroy(dead);
  EXPECT_EQ(graph.refusal(blender), "the ease blender 0 is to read an entity that does not exist");
  EXPECT_EQ(graph.refusal({}), "an agent is to read an entity that does not exist");
}

TEST(PoseProgram, RefusesAnEntityOfAnotherAgent) {
  Graph graph;
  const Handle theirs = graph.player(7);
  EXPECT_THAT(graph.refusal(graph.blend(graph.player(), theirs)),
              HasSubstr("the sampled player 0, which belongs to another agent: create it as shared"));
}

TEST(PoseProgram, RefusesMoreThan64Entities) {
  Graph graph;
  Handle root = graph.player();
  for (int i = 1; i < 64; ++i) root = graph.shaken(root);
  EXPECT_EQ(graph.refusal(root), "");
  EXPECT_THAT(graph.refusal(graph.shaken(root)), HasSubstr("more than 64 entities"));
}

TEST(PoseProgram, RefusesAnEntityOfMoreThanEightSources) {
  Graph graph;
  const Handle player = graph.player();
  const Handle mixer = graph.mix({player, player, player, player, player, player, player, player});
  EXPECT_EQ(graph.refusal(mixer), "");
  graph.pools.as<Mixer>(mixer).source_count = 9;
  EXPECT_EQ(graph.refusal(mixer), "the mixer 0 reads more than 8 sources");
}

TEST(PoseProgram, RefusesMoreThan128EntitiesBelowEachOtherByWayOfSharedOnes) {
  Graph graph;
  Handle below = graph.shared_player();
  PoseGraph chain;
  Status status = Done{};
  for (std::uint32_t owner = shared_owner + 1; status && owner < shared_owner + 10; ++owner) {
    for (int i = 0; i < 40; ++i) {
      const Handle above = graph.pools.create(EntityPools::noise_makers, true);
      graph.pools.state(above).owner = owner;
      graph.pools.as<NoiseMaker>(above).source = below;
      below = above;
    }
    status = compile_graph(graph.pools, below, owner, graph.programs, chain);
    EXPECT_EQ(status.has_value(), owner < shared_owner + 4) << "three graphs of 40 fit, a fourth does not";
  }
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, HasSubstr("more than 128 entities below it"));
}

TEST(PoseGraph, IsAsItWasWhenAnotherIsRefused) {
  Graph graph;
  PoseGraph fade = graph.graph_of(graph.blend(graph.player(), graph.player()));
  const PoseGraph before = fade;
  EXPECT_FALSE(compile_graph(graph.pools, graph.shaken({}), 0, graph.programs, fade));
  EXPECT_EQ(fade.program, before.program);
  EXPECT_EQ(fade.entities, before.entities);
}

TEST(PoseGraph, RunsOneProgramWithAllThatDifferInTheirEntitiesAlone) {
  Graph graph;
  const auto fade = [&] { return graph.graph_of(graph.blend(graph.player(), graph.player())); };
  const PoseGraph one = fade(), other = fade();
  EXPECT_EQ(one.program, other.program);
  EXPECT_NE(one.entities, other.entities);
  EXPECT_EQ(graph.programs.size(), 1U);
}

TEST(PoseGraph, RunsAnotherProgramWhereKindsOrSourcesDiffer) {
  Graph graph;
  const auto players = [&] { return std::array{graph.player(), graph.player()}; };
  const auto fade = [&](Handle from, Handle to) { return &graph.compiled(graph.blend(from, to)); };
  const auto mix_of_three = [&](std::size_t first, std::size_t second, std::size_t third) {
    const std::array two = players();
    return &graph.compiled(graph.mix({two[first], two[second], two[third]}));
  };
  const PoseProgram* const usual = fade(graph.player(), graph.player());
  EXPECT_NE(usual, &graph.compiled(graph.player()));
  EXPECT_NE(usual, &graph.compiled(graph.mix({graph.player(), graph.player()}))) << "another kind";
  const Handle only = graph.player();
  EXPECT_NE(usual, fade(only, only)) << "fewer steps";
  EXPECT_EQ(mix_of_three(0, 1, 0), mix_of_three(0, 1, 0));
  EXPECT_NE(mix_of_three(0, 1, 0), mix_of_three(0, 1, 1)) << "other sources";
}

TEST(PoseGraph, RunsOneProgramWithAllThatReadTheSameSharedEntities) {
  Graph graph;
  const Handle one = graph.shared_player(), other = graph.shared_player();
  const auto over = [&](Handle shared) { return &graph.compiled(graph.blend(shared, graph.player())); };
  EXPECT_EQ(over(one), over(one));
  EXPECT_NE(over(one), over(other));
}

TEST(PoseGraph, RunsAnotherProgramAfterItsBlocksChanged) {
  Graph graph;
  const Handle fade = graph.blend(graph.player(), graph.player());
  const PoseProgram& transient = graph.compiled(fade);
  graph.pools.set_residency(Residency::resident);
  const PoseProgram& resident = graph.compiled(fade);
  EXPECT_GT(resident.needs.fetch_bytes, transient.needs.fetch_bytes);
  graph.pools.set_residency(Residency::transient);
  EXPECT_EQ(&graph.compiled(fade), &transient) << "and the same one when they are as they were";
}

}  // namespace
}  // namespace throng::anim::pose_program_test
