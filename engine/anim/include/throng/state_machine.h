#pragma once

#include "throng/agent.h"
#include "throng/character.h"
#include "throng/ids.h"
#include "throng/result.h"
#include "throng/standard.h"
#include "throng/ticks.h"

namespace throng {

namespace detail {
struct MachineData;
}

/// States that play a clip or a blend space, and transitions between them, made for a character. It is read-only and
/// shared, as a Character is. Agent::add lays one over the channels of an agent, and Machine sets its inputs.
///
///     {
///       "inputs": [ {"name": "speed", "value": 0},
///                   {"name": "grounded", "value": true},
///                   {"name": "jump", "trigger": true} ],
///       "start": "move",
///       "states": [ {"name": "move", "by": "speed", "points": [ {"clip": "idle", "at": 0}, {"clip": "run", "at": 3.6}
///       ]},
///                   {"name": "jump", "clip": "jump", "loop": false, "speed": 1.2} ],
///       "transitions": [ {"from": "move", "to": "jump", "when": ["jump", "grounded"], "fade": 0.1},
///                        {"from": "jump", "to": "move", "at_end": true, "fade": 0.2} ]
///     }
///
/// A state blends "by" one number, or by two with points "at" two. "meaning" says what they are: "speed" or "plain",
/// and for two "velocity", "speed_and_turn" or "plain"; the first is the default (channels.h). A transition is taken
/// once all of "when" hold ("speed > 1.5", "grounded", "not grounded", "jump"), its state has played for "after"
/// seconds, and, with "at_end", the fade ends with the clip or with a loop of it. "from": "*" leads from any other
/// state. Of transitions due at once the first is taken. A trigger stays on until a transition that asks for it is
/// taken. There are at most 16 inputs, 64 states and 256 transitions.
class StateMachine {
 public:
  StateMachine() = default;
  explicit StateMachine(std::shared_ptr<const detail::MachineData> data) : data_(std::move(data)) {}
  explicit operator bool() const { return data_ != nullptr; }

  /// Reads a text. Errors: one sentence with the object and what to do, if the text is no JSON, or a value has the
  /// wrong type, names an absent thing, is out of its range, is never reached, or never rests; also if the library was
  /// built without throng::import, which reads JSON.
  static Result<StateMachine> parse(std::string_view json, const Character& character);
  /// Reads a file. Errors: as for a text, after the name of the file.
  static Result<StateMachine> load(const std::string& path, const Character& character);

  std::optional<std::uint32_t> find_input(std::string_view name) const;
  std::optional<std::uint32_t> find_state(std::string_view name) const;
  /// Returns the name of a state; an empty one if there is none of this number.
  std::string_view state_name(std::uint32_t state) const;

  const detail::MachineData* data() const { return data_.get(); }

 private:
  std::shared_ptr<const detail::MachineData> data_;
};

/// A state machine that an agent plays, as cheap to copy as a pointer:
///
///     const auto body = agent.add(machine);                        // a ChannelId
///     Machine(agent, *body).set(*machine.find_input("speed"), 2.5F);
///
/// A transition is taken at its time by the clock, to the tick, whether or not the agent is posed then.
class Machine {
 public:
  Machine(const Agent& agent, ChannelId channel) : crowd_(agent.crowd_), agent_(agent.id_), channel_(channel) {}

  /// Sets an input from the clock on. Flags and triggers are on at any number but 0.
  bool set(std::uint32_t input, float value) const;
  /// Sets a trigger or flag.
  bool fire(std::uint32_t input) const { return set(input, 1.0F); }
  /// Returns the state at the clock, and when it was entered; 0 where the agent plays no machine. The call
  /// brings the machine up to the clock, so it is a request, too.
  std::uint32_t state() const;
  Ticks entered_at() const;

 private:
  detail::CrowdParts* crowd_;
  AgentId agent_;
  ChannelId channel_;
};

}  // namespace throng
