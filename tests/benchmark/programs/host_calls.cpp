// What a host's own calls cost beside posing, one by one and many at a time: throng_host_calls MODEL [AGENTS [PUS]].
// The model has clips that play idle, walk and run, and a rig to look and stand with.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "throng/throng.h"

namespace throng {
namespace {

constexpr int rounds = 25;

double nanoseconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// A crowd that walks, looks and stands, with the requests of a frame.
struct Walkers {
  Crowd crowd;
  std::vector<AgentId> agents{};
  std::vector<std::byte> palettes{};
  std::vector<PoseRequest> poses{};
  std::vector<ParameterRequest> speeds{};
  std::vector<GazeRequest> gazes{};
  std::vector<PlacementRequest> places{};
  std::vector<GroundRequest> grounds{};
  std::vector<RootMotion> ways{};

  bool add(const Character& character, std::uint32_t count) {
    std::vector<BlendPoint> points;
    for (const char* role : {"stand", "walk", "run"}) {
      const ClipId clip = character.find_role(role);
      points.push_back({.clip = clip, .parameter = static_cast<float>(character.clip(clip).ground_speed)});
    }
    const std::size_t bytes = (crowd.palette_bytes(0) + 15) / 16 * 16;
    palettes.resize(bytes * count + 16);
    void* memory = palettes.data();
    std::size_t room = palettes.size();
    auto* const first = static_cast<std::byte*>(std::align(16, bytes * count, memory, room));
    for (const AgentId id : crowd.add_agents(count)) {
      const auto space = crowd.agent(id).add(BlendSpace{.points = points});
      const auto gaze = crowd.agent(id).add(LookAt{});
      const auto feet = crowd.agent(id).add(FootPlacement{});
      if (!space || !gaze || !feet) return false;
      agents.push_back(id);
      poses.push_back({.agent = id, .palette = first + bytes * id.number});
      speeds.push_back({.agent = id, .channel = *space});
      gazes.push_back({.agent = id, .gaze = *gaze, .target = {0.5F, 1.5F, 2.0F}});
      places.push_back({.agent = id, .process = *feet});
      grounds.push_back({.agent = id, .feet = *feet});
    }
    ways.resize(count);
    return true;
  }

  void frame() {
    crowd.advance(ticks_per_second / 60);
    crowd.update(poses);
  }
};

/// Prints the medians of calls one by one, of one call for all, and of their ratio.
void compare(Walkers& walkers, const char* what, const std::function<void()>& one_by_one,
             const std::function<void()>& together) {
  std::vector<double> alone, many, ratios;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < walkers.speeds.size(); ++i) {
      walkers.speeds[i].x = 0.8F + 0.1F * static_cast<float>(i % 9) + 0.001F * static_cast<float>(round);
    }
    walkers.frame();
    alone.push_back(nanoseconds(one_by_one));
    walkers.frame();
    many.push_back(nanoseconds(together));
    ratios.push_back(many.back() / alone.back());
  }
  const auto agents = static_cast<double>(walkers.agents.size());
  std::printf("%-14s %6.1f ns an agent one by one, %6.1f together, ratio %.2f\n", what, median(alone) / agents,
              median(many) / agents, median(ratios));
}

int run(const char* model, std::uint32_t count, int pus) {
  const auto file = load(model);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  auto crowd = Crowd::create(file->characters.front(), {.pus = pus});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;
  Walkers walkers{.crowd = std::move(*crowd)};
  if (!walkers.add(file->characters.front(), count)) return std::fprintf(stderr, "%s lacks a clip or rig\n", model), 1;
  const ManyAgents many = walkers.crowd.many();
  const auto agent = [&](AgentId id) { return walkers.crowd.agent(id); };
  std::vector<double> updates;
  for (int round = 0; round < rounds; ++round) updates.push_back(nanoseconds([&] { walkers.frame(); }));
  std::printf("%-14s %6.1f ns an agent, %u agents, %d PUs\n", "update", median(updates) / count, count, pus);
  compare(
      walkers, "set_parameters",
      [&] {
        for (const ParameterRequest& one : walkers.speeds) agent(one.agent).set_parameter(one.channel, one.x);
      },
      [&] { many.set_parameters(walkers.speeds); });
  compare(
      walkers, "look_at",
      [&] {
        for (const GazeRequest& one : walkers.gazes) agent(one.agent).processes().look_at(one.gaze, one.target);
      },
      [&] { many.look_at(walkers.gazes); });
  compare(
      walkers, "set_placements",
      [&] {
        for (const PlacementRequest& one : walkers.places)
          agent(one.agent).processes().set_placement(one.process, one.model_in_world);
      },
      [&] { many.set_placements(walkers.places); });
  compare(
      walkers, "set_grounds",
      [&] {
        for (const GroundRequest& one : walkers.grounds)
          agent(one.agent).processes().set_ground(one.feet, one.leg, one.point, one.normal);
      },
      [&] { many.set_grounds(walkers.grounds); });
  const auto since = [&] { return walkers.crowd.clock() - ticks_per_second / 60; };
  compare(
      walkers, "displacements",
      [&] {
        for (std::size_t i = 0; i < walkers.agents.size(); ++i)
          walkers.ways[i] = agent(walkers.agents[i]).motion().displacement(since(), walkers.crowd.clock());
      },
      [&] { many.displacements(since(), walkers.crowd.clock(), walkers.agents, walkers.ways); });
  return 0;
}

}  // namespace
}  // namespace throng

int main(int argument_count, char** arguments) {
  if (argument_count < 2 || argument_count > 4) {
    return std::fprintf(stderr, "throng_host_calls MODEL [AGENTS [PUS]]\n"), 2;
  }
  const int agents = argument_count > 2 ? std::atoi(arguments[2]) : 2000;
  const int pus = argument_count > 3 ? std::atoi(arguments[3]) : 1;
  return throng::run(arguments[1], static_cast<std::uint32_t>(std::max(agents, 1)), pus);
}
