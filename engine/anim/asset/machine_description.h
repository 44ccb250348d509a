#pragma once

#include <array>
#include <string>
#include <vector>

namespace throng::anim {

/// A state machine as its author writes it: names and texts, of which none is checked yet. `StateMachine::create`
/// (agent/channel/state_machine.h) checks them, and finds the things that they name.
struct MachineDescription {
  /// A number that the game sets. Conditions and blend spaces read it.
  struct Input {
    enum class Kind : unsigned char {
      number,
      flag,    ///< 0 or 1
      trigger  ///< 1 until a transition that asks for it is taken
    };
    std::string name;
    Kind kind = Kind::number;
    double value = 0.0;  ///< at the start
  };

  struct Point {
    std::string clip = {};
    std::array<double, 2> at{};  ///< the values of the inputs at which the clip is played alone
  };

  /// Plays a clip, or the clips of a blend space by one or two inputs.
  struct State {
    std::string name = {};
    std::string clip = {};
    double speed = 1.0;  ///< multiple of the clip's own
    bool loop = true;
    std::vector<std::string> by = {};  ///< inputs of a blend space; empty: the state plays `clip`
    std::vector<Point> points = {};
    /// Says what the inputs are: "speed" or "plain" for one; "velocity", "speed_and_turn" or "plain" for two
    /// (BlendSpaceChannel, PlaneMeaning). Empty: the first of these.
    std::string meaning = {};
  };

  struct Transition {
    static constexpr const char* any = "*";
    std::string from = {};               ///< a state, or `any`
    std::string to = {};                 ///< another state, or the same one, which begins anew
    std::vector<std::string> when = {};  ///< all hold: "speed > 1.5", "grounded", "not grounded"
    double after = 0.0;                  ///< seconds in the state, at least
    bool at_end = false;                 ///< the clip, or a loop of it, ends when the fade does
    double fade = 0.0;                   ///< seconds
  };

  std::vector<Input> inputs;
  std::vector<State> states;
  std::vector<Transition> transitions;  ///< of transitions that are due together, the first is taken
  std::string start = {};               ///< a state; empty: the first
};

}  // namespace throng::anim
