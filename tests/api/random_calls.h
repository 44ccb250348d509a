#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "throng/throng.h"

namespace throng::api_test {

/// Calls the public functions at random: any function in any order, with ids of agents that are gone, numbers that are
/// none, NaN, and the ends of every range. The same seed makes the same calls. Pointers alone are good, since no
/// library can check them.
class RandomCalls {
 public:
  RandomCalls(const Character& character, std::uint32_t seed);

  /// Makes one call.
  void call();
  /// Poses everybody, and returns how many numbers of their palettes are not finite.
  std::size_t pose_all();
  std::uint64_t calls() const { return calls_; }

 private:
  struct alignas(64) Line {
    float floats[16];
  };
  static constexpr std::uint32_t most_agents = 60;

  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  bool one_in(std::uint32_t times) { return below(times) == 0; }
  float number();
  std::uint32_t count();
  int index();
  Ticks time();
  Vec3 vector() { return {number(), number(), number()}; }
  Place place();
  AgentId agent_id();
  CharacterId character_id();
  ChannelId channel() { return {below(4) == 0 ? count() : below(4)}; }
  ProcessId process() { return {below(4) == 0 ? count() : below(6)}; }
  ClipId clip() { return {below(4) == 0 ? count() : below(12), one_in(3) ? below(3) : whichever}; }
  const Character& known_character() {
    return made_characters_[below(static_cast<std::uint32_t>(made_characters_.size()))];
  }
  MaskId mask() { return {below(3) == 0 ? below(3) : (below(6) == 0 ? count() : no_number)}; }
  Layer layer() { return {.weight = number(), .mask = mask()}; }
  Play play();
  CrowdOptions options();
  Agent agent() { return crowd_->agent(agent_id()); }

  void call_crowd();
  void call_characters();
  void call_clips();
  void call_agent();
  void call_machine();
  void add_process();
  void call_process();
  void call_many();
  void call_motion();
  void call_lod();
  void begin_again();

  std::mt19937 random_;
  Character character_;
  StateMachine machine_;
  std::unique_ptr<Crowd> crowd_;
  Lod lod_;
  Snapshot snapshot_;
  std::vector<AgentId> known_agents_;
  std::vector<CharacterId> known_characters_;
  std::vector<Character> made_characters_;  // of the one that it was given, with other clips
  std::vector<StepId> steps_;
  std::vector<Line> lines_;
  std::vector<PoseRequest> requests_;
  std::vector<Vec3> positions_;
  std::uint64_t calls_ = 0;
};

}  // namespace throng::api_test
