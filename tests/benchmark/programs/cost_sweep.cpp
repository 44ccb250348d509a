// The coefficients of anim::CostModel, by least squares over crowds of many shapes on one PU.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/commands/bench/case.h"
#include "app/commands/bench/crowd.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/show/figures/statistics.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/agent/targeted_processes.h"
#include "tests/benchmark/programs/least_squares.h"
#include "tests/benchmark/programs/program.h"

namespace throng::app {
namespace {

constexpr std::array names = {"tile", "tile_packet", "agent", "player_packet", "blender_packet", "post_process"};
constexpr int agents_of_a_crowd = 512;

struct Shape {
  int bones, players, tile, post_processes;
};

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  for (const int bones : {16, 62, 124}) {
    for (const int players : {1, 2, 3}) {
      for (const int tile : {1, 4, 16}) all.push_back({bones, players, tile, 0});
    }
    for (const int tile : {1, 4, 16}) all.push_back({bones, 1, tile, 1});
  }
  return all;
}

/// What CostModel multiplies its coefficients with, for one agent, in the order of `names`.
std::vector<double> parts_of(const Shape& shape, double tiles) {
  const int packets = anim::packets_for(shape.bones);
  return {tiles,
          tiles * packets,
          1.0,
          static_cast<double>(shape.players * packets),
          static_cast<double>((shape.players - 1) * packets),
          static_cast<double>(shape.post_processes)};
}

/// Crowds that live as long as the measurement.
struct ShapedCrowd {
  Shape shape;
  BenchCharacter character;
  std::optional<anim::CharacterRigs> rigs;
  std::unique_ptr<BenchPalettes> palettes;
  std::unique_ptr<anim::AnimationSystem> system;
  std::vector<PoseRequest> updates;

  /// An agent's share of a tile: held ones are narrower than asked for where the store was laid out for streaming ones.
  double tiles_an_agent() const {
    return system->figures().units().front().activity().tasks / double{agents_of_a_crowd};
  }
  void run() {
    system->advance(ticks_per_second / 60);
    system->update(updates);
  }
};

/// Null: this shape cannot be built here (nothing in the skeleton can gaze, or the tile does not fit).
std::unique_ptr<ShapedCrowd> make_crowd(const BenchOptions& options, const Shape& shape) {
  auto crowd = std::make_unique<ShapedCrowd>();
  crowd->shape = shape;
  auto character = bench_character({}, shape.bones, 3);
  if (!character) return nullptr;
  crowd->character = std::move(*character);
  anim::SystemOptions system = bench_system_options(options, {.pus = 1});
  system.local_store_bytes = std::size_t{1} << 20U;
  system.tile = shape.tile;
  auto made = anim::AnimationSystem::create(crowd->character.character, system);
  if (!made) return nullptr;
  crowd->system = std::move(*made);
  crowd->rigs.emplace(crowd->character.model);
  const anim::RigKinds kinds = crowd->rigs->add_to(*crowd->system);
  if (shape.post_processes > 0 && !kinds.look_at) return nullptr;
  crowd->palettes = std::make_unique<BenchPalettes>(agents_of_a_crowd, shape.bones);
  crowd->system->set_agent_count(agents_of_a_crowd);
  for (std::uint32_t agent = 0; agent < agents_of_a_crowd; ++agent) {
    for (int clip = 0; clip < shape.players; ++clip) {
      anim::PlayRequest request{.clip = clip, .start = Ticks{agent * 100}};
      if (clip > 0) request.held_fraction = 0.3F;
      crowd->system->agent(agent).play(request);
    }
    if (shape.post_processes > 0) {
      auto gaze = std::make_unique<anim::LookAtProcess>(*kinds.look_at);
      gaze->look_at({1.0F, 1.5F, 2.0F});
      if (!crowd->system->agent(agent).add_post_process(std::move(gaze))) return nullptr;
    }
    crowd->updates.push_back({.agent = {agent}, .palette = crowd->palettes->of(agent)});
  }
  return crowd;
}

/// Waking all PUs for nothing, after a pause as there is between frames, nanoseconds.
double wake_up_time(const BenchOptions& options) {
  auto character = bench_character({}, 1, 1);
  auto system =
      anim::AnimationSystem::create(character->character, bench_system_options(options, {.pus = options.pus.front()}));
  if (!system) return 0;
  std::vector<double> times;
  for (int i = 0; i < 300; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto start = std::chrono::steady_clock::now();
    (*system)->executor().run((*system)->options().pus, {[](void*, int) {}, nullptr});
    times.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  return median(std::move(times));
}

std::string key_of(std::size_t index) { return std::to_string(index); }

Result<BenchReport> sweep_cost(const BenchOptions& options) {
  std::vector<std::unique_ptr<ShapedCrowd>> crowds;
  BenchRounds rounds;
  for (const Shape& shape : shapes()) {
    auto crowd = make_crowd(options, shape);
    if (crowd == nullptr) continue;
    rounds.add({key_of(crowds.size()), [work = crowd.get()] { work->run(); }});
    crowds.push_back(std::move(crowd));
  }
  rounds.run(options.frames, "cost: ");

  LeastSquares fit(names.size());
  std::vector<Json> rows;
  for (std::size_t i = 0; i < crowds.size(); ++i) {
    const double agent_ns = rounds.times().fastest(key_of(i)) / agents_of_a_crowd;
    fit.add(parts_of(crowds[i]->shape, crowds[i]->tiles_an_agent()), agent_ns, 1.0 / agent_ns);
    const Shape& shape = crowds[i]->shape;
    rows.push_back({{"bones", shape.bones},
                    {"players", shape.players},
                    {"post_processes", shape.post_processes},
                    {"tile", 1.0 / crowds[i]->tiles_an_agent()},
                    {"measured_ns", agent_ns}});
  }
  const std::vector<double> coefficients = fit.solve_without_negatives();
  double worst = 0, mean = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> parts = parts_of(crowds[i]->shape, crowds[i]->tiles_an_agent());
    double predicted = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) predicted += parts[k] * coefficients[k];
    const double error = std::abs(predicted / rows[i]["measured_ns"].get<double>() - 1.0);
    rows[i]["predicted_ns"] = predicted;
    worst = std::max(worst, error);
    mean += error / static_cast<double>(rows.size());
  }

  BenchReport report;
  report.json["sweep"] = "cost";
  for (std::size_t k = 0; k < names.size(); ++k) report.json[std::string(names[k]) + "_ns"] = coefficients[k];
  report.json["least_task_ns"] = wake_up_time(options);
  report.json["mean_error_percent"] = 100.0 * mean;
  report.json["worst_error_percent"] = 100.0 * worst;
  report.text =
      figures_as_text({&report.json, 1}, {}) + "\n" +
      figures_as_text(rows, std::array{"bones", "players", "post_processes", "tile", "measured_ns", "predicted_ns"});
  report.json["rows"] = rows;
  return report;
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  return throng::app::run_bench_program(argument_count, arguments, throng::app::sweep_cost);
}
