#include "app/show/figures/timeline_log.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/app/program_run.h"
#include "tests/own_folder.h"

namespace throng::app::timeline_log_test {
namespace {

nlohmann::json trace_of_a_run(const std::string& schedule) {
  const throng::test::OwnFolder folder;
  const std::filesystem::path file = folder.path() / "trace.json";
  const ProgramRun run = run_program({"--headless=none", "--agents", "40", "--frames", "3", "--lod", "off", "--pus",
                                      "2", "--schedule", schedule, "--trace", file.string()});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  std::ifstream stream(file);
  return nlohmann::json::parse(stream, nullptr, false);
}

TEST(TraceFile, HasALaneForTheFrameAndOneAPu) {
  const nlohmann::json trace = trace_of_a_run("fused");
  ASSERT_TRUE(trace.is_object());
  std::map<int, std::string> lanes;
  for (const auto& event : trace["traceEvents"]) {
    if (event["name"] == "thread_name") lanes[event["tid"]] = event["args"]["name"];
  }
  EXPECT_THAT(lanes,
              testing::ElementsAre(testing::Pair(0, "frame"), testing::Pair(1, "PU 0"), testing::Pair(2, "PU 1")));
}

std::set<std::string> kinds_of_spans(const nlohmann::json& trace) {
  std::set<std::string> kinds;
  for (const auto& event : trace["traceEvents"]) {
    if (event["ph"] == "X" && event["tid"] != 0) kinds.insert(event["name"]);
  }
  return kinds;
}

TEST(TraceFile, ShowsFetchComputeWriteBackAndWait) {
  EXPECT_THAT(kinds_of_spans(trace_of_a_run("fused")),
              testing::IsSupersetOf({"fetch", "compute", "write back", "wait", "schedule"}));
}

TEST(TraceFile, ShowsTheBarriersOfThePapersSchedule) {
  EXPECT_THAT(kinds_of_spans(trace_of_a_run("levels")),
              testing::IsSupersetOf({"fetch", "compute", "write back", "wait", "schedule"}));
}

TEST(TraceFile, NamesTheAgentsOfEachTask) {
  const nlohmann::json trace = trace_of_a_run("fused");
  int agents = 0;
  for (const auto& event : trace["traceEvents"]) {
    if (event["name"] != "compute") continue;
    EXPECT_LE(event["args"]["first_agent"], event["args"]["last_agent"]);
    EXPECT_LT(event["args"]["last_agent"], 40);
    agents += event["args"]["agents"].get<int>();
  }
  EXPECT_EQ(agents, 3 * 40) << "everybody in each frame";
}

TEST(TraceFile, PutsTheWorkOfPusInsideTheirFrame) {
  constexpr double rounding_us = 0.01;
  const nlohmann::json trace = trace_of_a_run("fused");
  double begin = 0, end = 0;
  int frames = 0;
  for (const auto& event : trace["traceEvents"]) {
    if (event["ph"] != "X") continue;
    const double from = event["ts"], to = from + event["dur"].get<double>();
    if (event["tid"] == 0) {
      begin = from;
      end = to;
      ++frames;
    }
    EXPECT_GE(from, begin - rounding_us);
    EXPECT_LE(to, end + rounding_us);
  }
  EXPECT_EQ(frames, 3);
}

TEST(TraceFile, NumbersFramesAndHasTheirFiguresAsCurves) {
  const nlohmann::json trace = trace_of_a_run("fused");
  std::vector<int> frames;
  std::map<std::string, std::vector<double>> curves;
  for (const auto& event : trace["traceEvents"]) {
    if (event["name"] == "update" && event["ph"] == "X") frames.push_back(event["args"]["frame"]);
    if (event["ph"] == "C") curves[event["name"]].push_back(event["args"].items().begin().value());
  }
  EXPECT_THAT(frames, testing::ElementsAre(1, 2, 3));
  EXPECT_THAT(curves["agents updated"], testing::ElementsAre(40, 40, 40));
  EXPECT_THAT(curves["update"], testing::Each(testing::Gt(0.0)));
  EXPECT_EQ(curves["error p99"].size(), 3U);
  EXPECT_EQ(curves["pop"].size(), 3U);
}

TEST(TimelineLog, HasDrawingAndOverlayOnTracksOfTheirOwn) {
  const auto character = std::make_shared<const anim::Character>(anim::bake_character(anim::synthetic_model(4, 1)));
  auto system = anim::AnimationSystem::create(character, {.pus = 1});
  ASSERT_TRUE(system.has_value());
  TimelineLog log;
  const auto start = TimelineLog::Clock::now();
  log.add_update(**system, start, {.frame = 7});
  log.add_drawing(start, TimelineLog::Clock::now());
  log.add_overlay(start, TimelineLog::Clock::now());
  std::map<std::string, int> track_of, spans;
  const nlohmann::json trace = nlohmann::json::parse(log.to_json());
  for (const auto& event : trace["traceEvents"]) {
    if (event["name"] == "thread_name") track_of[event["args"]["name"]] = event["tid"];
    if (event["ph"] == "X" && event["args"].contains("frame")) {
      EXPECT_EQ(event["args"]["frame"], 7);
      spans[event["name"]] = event["tid"];
    }
  }
  EXPECT_EQ(spans.at("draw"), track_of.at("drawing"));
  EXPECT_EQ(spans.at("overlay"), track_of.at("overlay"));
  EXPECT_EQ(spans.at("update"), track_of.at("frame"));
}

TEST(TimelineLog, KeepsTheNewestFramesOnly) {
  const auto character = std::make_shared<const anim::Character>(anim::bake_character(anim::synthetic_model(4, 1)));
  auto system = anim::AnimationSystem::create(character, {.pus = 1, .tile = 1, .trace = anim::Tracing::every_task});
  ASSERT_TRUE(system.has_value());
  constexpr std::uint32_t agents = 20'000;
  (*system)->set_agent_count(agents);
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    (*system)->agent(agent).play({});
    updates.push_back({.agent = {agent}});
  }
  TimelineLog log;
  for (int frame = 0; frame < 20; ++frame) {
    const auto start = TimelineLog::Clock::now();
    (*system)->update(updates);
    log.add_update(**system, start);
  }
  const nlohmann::json trace = nlohmann::json::parse(log.to_json());
  EXPECT_LE(trace["traceEvents"].size(), TimelineLog::most_spans + 3);
  EXPECT_GT(trace["traceEvents"].size(), TimelineLog::most_spans / 2);
  EXPECT_GT(trace["traceEvents"][3]["ts"], 0.0) << "the first frames are gone";
}

}  // namespace
}  // namespace throng::app::timeline_log_test
