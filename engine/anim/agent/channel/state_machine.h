#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/anim/agent/blend_space_2d_channel.h"
#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/asset/machine_description.h"
#include "engine/base/result.h"

namespace throng::anim {

/// States that play a clip or a blend space, and transitions between them, checked for a character. It is read-only;
/// any number of StateMachineChannels share it.
class StateMachine {
 public:
  static constexpr std::size_t most_inputs = 16;
  static constexpr std::size_t most_states = 64;
  static constexpr std::size_t most_transitions = 256;
  using Inputs = std::array<float, most_inputs>;  ///< [input]; flags and triggers are 0 or 1

  /// Compares an input with a number.
  struct Condition {
    enum class Is : unsigned char { less, at_most, more, at_least };
    std::uint8_t input = 0;
    Is is = Is::more;
    float value = 0.0F;

    bool holds(const Inputs& inputs) const;
  };

  struct State {
    std::string name;
    PlayerStart clip = {};                                       ///< what it plays, if it has no points
    std::shared_ptr<const std::vector<BlendPoint>> points = {};  ///< along one input; or null
    std::shared_ptr<const BlendSpace2d> plane = {};              ///< by two inputs; or null
    std::array<std::uint8_t, 2> by{};                            ///< these inputs
    bool is_ground_speed = false;                                ///< of a space along one input
    std::vector<std::uint16_t> transitions = {};                 ///< that lead from it, in their order

    bool is_blend_space() const { return points != nullptr || plane != nullptr; }
  };

  struct Transition {
    std::uint8_t to = 0;
    bool at_end = false;
    Ticks after{};
    Ticks fade{};
    std::vector<Condition> when = {};

    bool holds(const Inputs& inputs) const;
  };

  /// Errors, in a sentence that names the state, transition or input: a name that is absent or is there twice;
  /// a number out of its range; a state that no transition leads to; states that lead to each other at once, forever;
  /// too many inputs, states or transitions.
  static Result<std::shared_ptr<const StateMachine>> create(const MachineDescription& description,
                                                            const Character& character);

  std::optional<std::uint32_t> find_input(std::string_view name) const;
  std::optional<std::uint32_t> find_state(std::string_view name) const;
  std::size_t input_count() const { return inputs_.size(); }
  const MachineDescription::Input& input(std::uint32_t index) const { return inputs_[index]; }
  const Inputs& starting_inputs() const { return starting_inputs_; }
  std::span<const State> states() const { return states_; }
  const Transition& transition(std::uint16_t index) const { return transitions_[index]; }
  std::uint8_t start() const { return start_; }

  /// Calls visit(int clip) for the number of each clip that a state plays.
  void for_each_clip(const std::function<void(int)>& visit) const;

  /// Lowers the triggers that a transition asks for.
  void use_triggers(const Transition& taken, Inputs& inputs) const;

 private:
  friend class StateMachineBuilder;
  StateMachine() = default;

  std::vector<MachineDescription::Input> inputs_;
  Inputs starting_inputs_{};
  std::vector<State> states_;
  std::vector<Transition> transitions_;
  std::uint8_t start_ = 0;
};

}  // namespace throng::anim
