// Level of detail chooses what is posed, never what happens: where agents are, what they do, and which data keys they
// meet, in which order.

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"

namespace throng::app::lod_events_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr float least_weight = 1e-3F;  // what faded out may still be in an agent's graph until it is posed again

/// What an agent met, in order.
struct Met {
  std::uint32_t name, clip;
  Ticks time;
  friend bool operator==(const Met&, const Met&) = default;
};

/// A plaza, and what everyone in it met so far.
class Watched {
 public:
  Watched(LodRule lod, int agents) : met_(static_cast<std::size_t>(agents)) {
    const char* const mannequin = THRONG_SOURCE_DIR "/assets/mannequin.glb";
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(mannequin, mannequin));
    const bool off = lod == LodRule::off;
    const Tuning tuning{.agents = agents, .lod = {.rule = lod, .bone_lod = !off, .smooth = !off}, .system = {.pus = 2}};
    stage_ = std::move(*Stage::create(std::move(characters), tuning, pages_));
    stage_->animated().sum_up_events();
  }

  void pass_frame() {
    const Ticks before = stage_->system().clock();
    stage_->move(frame);
    for (std::uint32_t agent = 0; agent < met_.size(); ++agent) {
      stage_->system().agent(agent).motion().for_each_data_key(
          before, stage_->system().clock(), [&](const anim::DataKeyEvent& event) {
            if (event.weight > least_weight) met_[agent].push_back({event.name, event.clip, event.time});
          });
    }
    stage_->pose(camera_, 1280, 720, frame, stage_->posed().frame());
  }

  const Crowd& crowd() const { return stage_->crowd(); }
  const std::vector<std::vector<Met>>& met() const { return met_; }
  const EventSums& sums() const { return *stage_->animated().event_sums(); }
  std::uint64_t posed() const { return stage_->system().figures().report().agents_updated; }

 private:
  HeapPageSource pages_{std::size_t{1} << 22U};
  std::unique_ptr<Stage> stage_;
  render::Camera camera_ = camera_at({.x = 0, .y = 12, .z = 25, .yaw = 0, .pitch = -25});
  std::vector<std::vector<Met>> met_;  // [agent]
};

bool same_places(const Crowd& a, const Crowd& b) {
  return std::memcmp(a.positions().data(), b.positions().data(), a.positions().size_bytes()) == 0 &&
         std::memcmp(a.headings().data(), b.headings().data(), a.headings().size_bytes()) == 0;
}

/// Of the first event in which they differ; nothing where they are equal.
std::string first_difference(const std::vector<Met>& exact, const std::vector<Met>& skipping) {
  const auto [one, other] = std::ranges::mismatch(exact, skipping);
  if (one == exact.end() && other == skipping.end()) return {};
  const auto words = [](auto event, auto end) {
    if (event == end) return std::string("nothing");
    return "name " + std::to_string(event->name) + " of clip " + std::to_string(event->clip) + " at " +
           std::to_string(to_seconds(event->time)) + " s";
  };
  return "event " + std::to_string(one - exact.begin()) + ": " + words(one, exact.end()) + ", with skipping " +
         words(other, skipping.end());
}

class LodEvents : public testing::TestWithParam<LodRule> {};

TEST_P(LodEvents, AreTheSameInTheSameOrderAsWithoutAndSoArePlaces) {
  constexpr int agents = 100, frames = 2400;
  Watched exact(LodRule::off, agents), skipping(GetParam(), agents);
  std::uint64_t posed = 0;
  const auto before = std::pair(exact.sums().event_hash(), exact.sums().place_hash());
  for (int i = 0; i < frames; ++i) {
    exact.pass_frame();
    skipping.pass_frame();
    posed += skipping.posed();
    ASSERT_TRUE(same_places(exact.crowd(), skipping.crowd())) << "frame " << i;
  }
  EXPECT_LT(posed, static_cast<std::uint64_t>(agents) * frames / 2) << "most updates were skipped";
  std::size_t events = 0;
  for (std::size_t agent = 0; agent < agents; ++agent) {
    EXPECT_EQ(first_difference(exact.met()[agent], skipping.met()[agent]), "") << "agent " << agent;
    events += exact.met()[agent].size();
  }
  EXPECT_EQ(exact.sums().event_hash(), skipping.sums().event_hash());
  EXPECT_EQ(exact.sums().place_hash(), skipping.sums().place_hash());
  EXPECT_NE(exact.sums().event_hash(), before.first) << "somebody met something";
  EXPECT_NE(exact.sums().place_hash(), before.second) << "and went somewhere";
  EXPECT_GT(events, 500U) << "people walk, and steps are data keys";
}

INSTANTIATE_TEST_SUITE_P(Rules, LodEvents, testing::Values(LodRule::distance, LodRule::budget),
                         [](const auto& tested) { return tested.param == LodRule::distance ? "Distance" : "Budget"; });

}  // namespace
}  // namespace throng::app::lod_events_test
