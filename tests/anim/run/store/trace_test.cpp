#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::trace_test {
namespace {

constexpr std::uint32_t agents = 100;

/// A crowd that fades, after one update.
CrowdRig fading_crowd(const SystemOptions& options) {
  CrowdRig crowd(options, agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    crowd->agent(agent).play({.clip = 0});
    crowd->agent(agent).play({.clip = 1, .fade = ticks_per_second});
  }
  crowd.step();
  return crowd;
}

std::vector<SystemOptions> every_schedule_and_mode(Tracing tracing = Tracing::on) {
  std::vector<SystemOptions> all;
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const auto mode : {DoubleBuffering::off, DoubleBuffering::inline_copy, DoubleBuffering::interleaved}) {
      all.push_back({.pus = 2, .schedule = schedule, .double_buffering = mode, .trace = tracing});
    }
  }
  return all;
}

bool is_slice(const TraceSpan& span) { return span.kind == TraceSpan::Kind::copy_slice; }

std::size_t count_of(const Trace& trace, TraceSpan::Kind kind) {
  return static_cast<std::size_t>(std::ranges::count(trace.spans(), kind, &TraceSpan::kind));
}

TEST(Trace, HasNoGapFromTheStartOfAnUpdateToItsEnd) {
  for (const SystemOptions& options : every_schedule_and_mode()) {
    const CrowdRig crowd = fading_crowd(options);
    for (const ProcessingUnit& unit : crowd->figures().units()) {
      std::uint64_t last = crowd->figures().update_time().first_tick;
      for (const TraceSpan& span : unit.trace().spans()) {
        if (is_slice(span)) continue;
        EXPECT_EQ(span.begin, last);
        EXPECT_GE(span.end, span.begin);
        last = span.end;
      }
      EXPECT_EQ(unit.trace().spans().back().kind, TraceSpan::Kind::wait);
      EXPECT_LE(last, crowd->figures().update_time().last_tick);
      EXPECT_EQ(unit.trace().not_kept(), 0U);
    }
  }
}

TEST(Trace, NamesEveryByteAndTransferThatWasCopied) {
  for (const SystemOptions& options : every_schedule_and_mode()) {
    const CrowdRig crowd = fading_crowd(options);
    CopyCounts sum;
    for (const ProcessingUnit& unit : crowd->figures().units()) {
      for (const TraceSpan& span : unit.trace().spans()) sum += {span.bytes_in, span.bytes_out, span.transfers};
    }
    EXPECT_EQ(sum.bytes_in, crowd->figures().report().copies.bytes_in);
    EXPECT_EQ(sum.bytes_out, crowd->figures().report().copies.bytes_out);
    EXPECT_EQ(sum.transfers, crowd->figures().report().copies.transfers);
  }
}

/// Of all compute spans; each agent once where each is in one tile.
std::size_t agents_computed(const CrowdRig& crowd) {
  std::size_t sum = 0;
  for (const ProcessingUnit& unit : crowd->figures().units()) {
    for (const TraceSpan& span : unit.trace().spans()) {
      if (span.kind == TraceSpan::Kind::compute) sum += span.content.agents;
    }
  }
  return sum;
}

TEST(Trace, NamesTheAgentsOfEveryTask) {
  for (const Tracing tracing : {Tracing::on, Tracing::every_task}) {
    for (const auto mode : {DoubleBuffering::off, DoubleBuffering::inline_copy, DoubleBuffering::interleaved}) {
      const CrowdRig crowd = fading_crowd({.pus = 2, .double_buffering = mode, .trace = tracing});
      EXPECT_GE(agents_computed(crowd), agents);
      if (tracing == Tracing::every_task) {
        EXPECT_EQ(agents_computed(crowd), agents);
      }
      std::uint32_t last = 0;
      for (const ProcessingUnit& unit : crowd->figures().units()) {
        for (const TraceSpan& span : unit.trace().spans()) {
          const bool works = span.kind != TraceSpan::Kind::wait && span.kind != TraceSpan::Kind::schedule;
          if (is_slice(span)) continue;
          EXPECT_EQ(span.content.agents > 0, works);
          EXPECT_LE(span.content.first_agent, span.content.last_agent);
          last = std::max(last, span.content.last_agent);
        }
      }
      EXPECT_EQ(last, agents - 1);
    }
  }
}

TEST(Trace, CountsTheEntitiesOfAnAgentOnceASpan) {
  constexpr std::size_t stages = 3;  // players, of which each agent has two, blenders, palettes
  const std::size_t computed = agents_computed(fading_crowd({.pus = 1, .schedule = Schedule::levels}));
  EXPECT_GE(computed, stages * agents);
  EXPECT_LT(computed, (stages + 1) * agents) << "few spans begin or end in the middle of an agent or a tile";
}

TEST(TaskContent, OfATileIsItsLowestAndItsHighestAgentInWhateverOrderTheyAre) {
  for (const std::vector<std::uint32_t>& numbers :
       {std::vector<std::uint32_t>{5, 6, 9}, {5, 9, 6}, {9, 6, 5}, {6, 5, 9}}) {
    std::vector<AgentWork> tile;
    for (const std::uint32_t agent : numbers) tile.push_back({.agent = agent, .level = 2});
    EXPECT_EQ(content_of(tile), (TaskContent{.first_agent = 5, .last_agent = 9, .agents = 3, .bone_level = 2}));
  }
}

TEST(JoinedContent, OfSeveralTasksIsFromTheLowestAgentToTheHighest) {
  JoinedContent joined;
  joined.add({.first_agent = 40, .last_agent = 55, .agents = 16, .bone_level = 1});
  joined.add({.first_agent = 40, .last_agent = 55, .agents = 16, .bone_level = 1});
  EXPECT_EQ(joined.all().agents, 16) << "the same once more";
  joined.add({});
  joined.add({.first_agent = 3, .last_agent = 70, .agents = 8, .bone_level = 2});
  const TaskContent expected{
      .first_agent = 3, .last_agent = 70, .agents = 24, .bone_level = TaskContent::several_levels};
  EXPECT_EQ(joined.all(), expected);
}

TEST(Trace, HasAComputeSpanForEachTask) {
  for (const SystemOptions& options : every_schedule_and_mode(Tracing::every_task)) {
    const CrowdRig crowd = fading_crowd(options);
    std::size_t tasks = 0, spans = 0;
    for (const ProcessingUnit& unit : crowd->figures().units()) {
      tasks += unit.activity().tasks;
      spans += count_of(unit.trace(), TraceSpan::Kind::compute);
    }
    if (options.schedule == Schedule::fused) {
      EXPECT_EQ(spans, tasks);
    } else {
      EXPECT_GT(spans, tasks) << "the palettes of a tile are a task a packet";
    }
  }
}

TEST(Trace, JoinsTasksThatAreTooShortToBeTimedOneByOne) {
  const CrowdRig crowd = fading_crowd({.pus = 1, .schedule = Schedule::levels});
  const ProcessingUnit& unit = crowd->figures().units().front();
  EXPECT_LT(count_of(unit.trace(), TraceSpan::Kind::compute), unit.activity().tasks / 4);
  EXPECT_GT(count_of(unit.trace(), TraceSpan::Kind::compute), 4U);
}

TEST(Trace, ShowsAWaitAtEachBarrierOfThePapersSchedule) {
  const CrowdRig crowd = fading_crowd({.pus = 1, .schedule = Schedule::levels});
  EXPECT_EQ(count_of(crowd->figures().units().front().trace(), TraceSpan::Kind::wait), 4U)
      << "players, blenders, palettes, and the end of the update";
}

TEST(Trace, ShowsTheSlicesOfCopiesWithinComputeSpans) {
  const CrowdRig crowd =
      fading_crowd({.pus = 1, .double_buffering = DoubleBuffering::interleaved, .trace = Tracing::every_task});
  const std::span<const TraceSpan> spans = crowd->figures().units().front().trace().spans();
  const auto slice = std::ranges::find_if(spans, is_slice);
  ASSERT_NE(slice, spans.end());
  const auto owner = std::find_if_not(slice, spans.end(), is_slice);
  ASSERT_NE(owner, spans.end());
  EXPECT_EQ(owner->kind, TraceSpan::Kind::compute);
  EXPECT_LE(owner->begin, slice->begin);
  EXPECT_GE(owner->end, slice->end);
}

TEST(Trace, RecordsNothingWhereItIsOff) {
  const CrowdRig crowd = fading_crowd({.pus = 2, .trace = Tracing::off});
  for (const ProcessingUnit& unit : crowd->figures().units()) EXPECT_TRUE(unit.trace().spans().empty());
}

TEST(Trace, CountsWhatDoesNotFit) {
  Trace trace;
  trace.reserve(2, Tracing::on);
  trace.begin(TraceClock::now());
  for (int i = 0; i < 5; ++i) trace.close(TraceSpan::Kind::compute);
  EXPECT_EQ(trace.spans().size(), 2U);
  EXPECT_EQ(trace.not_kept(), 3U);
}

}  // namespace
}  // namespace throng::anim::trace_test
