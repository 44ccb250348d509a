// A state machine finds what its names mean, or is refused in a sentence.

#include "engine/anim/agent/channel/state_machine.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::state_machine_test {
namespace {

using testing::HasSubstr;
using Kind = MachineDescription::Input::Kind;

/// Moves by speed, jumps and lands.
MachineDescription jumper() {
  MachineDescription machine;
  machine.inputs = {{.name = "speed"},
                    {.name = "turn"},
                    {.name = "grounded", .kind = Kind::flag, .value = 1.0},
                    {.name = "jump", .kind = Kind::trigger}};
  machine.states = {{.name = "move", .by = {"speed"}, .points = {{"clip_0", {0.0}}, {"clip_1", {3.0}}}},
                    {.name = "jump", .clip = "clip_2", .loop = false}};
  machine.transitions = {{.from = "move", .to = "jump", .when = {"jump", "grounded"}, .fade = 0.1},
                         {.from = "jump", .to = "move", .at_end = true, .fade = 0.2}};
  return machine;
}

/// Returns the sentence with which a machine is refused after it was changed.
template <typename Change>
std::string refusal(Change&& change) {
  MachineDescription machine = jumper();
  change(machine);
  const auto made = StateMachine::create(machine, *test_character());
  return made ? "(taken)" : made.error().message;
}

TEST(StateMachine, FindsWhatItsNamesMean) {
  const auto machine = StateMachine::create(jumper(), *test_character());
  ASSERT_TRUE(machine) << machine.error().message;
  EXPECT_EQ((*machine)->find_state("jump"), 1U);
  EXPECT_EQ((*machine)->find_input("jump"), 3U);
  EXPECT_EQ((*machine)->find_input("leap"), std::nullopt);
  EXPECT_EQ((*machine)->states()[1].clip.clip, 2);
  EXPECT_EQ((*machine)->states()[0].points->back().clip, 1);
  EXPECT_EQ((*machine)->starting_inputs()[2], 1.0F);
}

TEST(StateMachine, RefusesNamesThatThereAreNot) {
  EXPECT_EQ(
      refusal([](auto& m) { m.states[1].clip = "leap"; }),
      "state \"jump\" plays clip \"leap\", which \"synthetic\" has not: choose one of clip_0, clip_1, clip_2, clip_3, "
      "clip_4");
  EXPECT_EQ(refusal([](auto& m) { m.transitions[0].to = "leap"; }),
            "the transition from \"move\" to \"leap\" leads to no state of this name: name one of the states");
  EXPECT_THAT(refusal([](auto& m) { m.transitions[1].from = "leap"; }), HasSubstr("leads from no state of this name"));
  EXPECT_THAT(refusal([](auto& m) { m.start = "leap"; }), HasSubstr("starts in \"leap\", which is no state"));
  EXPECT_EQ(
      refusal([](auto& m) { m.transitions[0].when = {"leap"}; }),
      "the transition from \"move\" to \"jump\" has a condition, \"leap\", which names no input: give the machine an "
      "input \"leap\"");
  EXPECT_THAT(refusal([](auto& m) { m.states[0].by = {"grounded"}; }), HasSubstr("is no input that is a number"));
}

TEST(StateMachine, RefusesNamesThatAreThereTwice) {
  EXPECT_EQ(refusal([](auto& m) { m.states.push_back(m.states[0]); }),
            "state \"move\" is there twice: give each a name of its own");
  EXPECT_EQ(refusal([](auto& m) { m.inputs.push_back(m.inputs[0]); }),
            "input \"speed\" is there twice: give each a name of its own");
}

TEST(StateMachine, RefusesNamesThatCannotBeTold) {
  EXPECT_THAT(refusal([](auto& m) { m.inputs[0].name = "not"; }), HasSubstr("letters, digits and underscores"));
  EXPECT_THAT(refusal([](auto& m) { m.inputs[0].name = "a b"; }), HasSubstr("letters, digits and underscores"));
  EXPECT_THAT(refusal([](auto& m) { m.states[0].name = "*"; }), HasSubstr("needs another name"));
}

TEST(StateMachine, ShowsNamesAsPlainText) {
  const std::string told = refusal([](auto& m) { m.states[1].clip = "\x1b[2J"; });
  EXPECT_EQ(told.find('\x1b'), std::string::npos) << "it would clear a terminal";
}

TEST(StateMachine, RefusesConditionsThatSayNothing) {
  const auto because = [](const char* condition) {
    return refusal([&](auto& m) { m.transitions[0].when = {condition}; });
  };
  for (const char* taken :
       {"speed > 1.5", "speed>=1.5", " speed <= -1e1 ", "speed<2", "grounded", "not grounded", "jump"}) {
    EXPECT_EQ(because(taken), "(taken)") << taken;
  }
  EXPECT_THAT(because("speed"), HasSubstr("is no comparison of a number: write \"speed > 1.5\""));
  EXPECT_THAT(because("speed > fast"), HasSubstr("is no comparison of a number"));
  EXPECT_THAT(because("speed > 1.5 2"), HasSubstr("is no comparison of a number"));
  EXPECT_THAT(because("speed => 1.5"), HasSubstr("is no comparison of a number"));
  EXPECT_THAT(because("speed > 1e99"), HasSubstr("is no comparison of a number"));
  EXPECT_THAT(because("not speed > 1"), HasSubstr("is no comparison of a number"));
  EXPECT_THAT(because("grounded > 0"), HasSubstr("write \"grounded\" alone"));
  EXPECT_THAT(because("not jump"), HasSubstr("use a flag"));
  EXPECT_THAT(because(""), HasSubstr("names no input"));
}

TEST(StateMachine, RefusesNumbersOutOfTheirRange) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double number : {-1.0, 1e9, infinite, nan}) {
    EXPECT_THAT(refusal([&](auto& m) { m.transitions[0].fade = number; }), HasSubstr("takes times from 0 to 86,400"))
        << number;
    EXPECT_THAT(refusal([&](auto& m) { m.transitions[0].after = number; }), HasSubstr("takes times from 0 to"))
        << number;
  }
  for (const double number : {40000.0, infinite, nan}) {
    EXPECT_THAT(refusal([&](auto& m) { m.states[1].speed = number; }), HasSubstr("speed out of range")) << number;
  }
  EXPECT_THAT(refusal([&](auto& m) { m.inputs[0].value = nan; }), HasSubstr("begins with a finite number"));
  EXPECT_THAT(refusal([&](auto& m) { m.states[0].points[1].at[0] = nan; }), HasSubstr("at a place that is no number"));
  EXPECT_THAT(refusal([&](auto& m) { m.states[0].points[1].at[0] = 0.0; }), HasSubstr("points out of order"));
}

TEST(StateMachine, RefusesStatesThatPlayNothingOrTwoThings) {
  EXPECT_THAT(refusal([](auto& m) { m.states[1].clip = ""; }), HasSubstr("plays either a clip or points"));
  EXPECT_THAT(refusal([](auto& m) { m.states[0].clip = "clip_0"; }), HasSubstr("plays either a clip or points"));
  EXPECT_THAT(refusal([](auto& m) { m.states[0].by.clear(); }), HasSubstr("name them in \"by\""));
  EXPECT_THAT(refusal([](auto& m) { m.states[0].meaning = "haste"; }),
              HasSubstr("one input is \"speed\" or \"plain\""));
  EXPECT_THAT(refusal([](auto& m) {
                m.states[0].by = {"speed", "turn"}, m.states[0].meaning = "haste";
              }),
              HasSubstr("two inputs are"));
  EXPECT_THAT(refusal([](auto& m) {
                m.states[0].by = {"speed", "turn"}, m.states[0].points[1].at = {};
              }),
              HasSubstr("make no plane"));
  EXPECT_EQ(refusal([](auto& m) { m.states.clear(); }), "a state machine has states: give it one");
}

TEST(StateMachine, RefusesStatesThatAreNeverReached) {
  EXPECT_EQ(refusal([](auto& m) { m.transitions.erase(m.transitions.begin()); }),
            "state \"jump\" is never reached from \"move\": add a transition that leads to it, or leave it out");
}

TEST(StateMachine, RefusesStatesThatNeverRest) {
  EXPECT_THAT(refusal([](auto& m) { m.transitions[1] = {.from = "jump", .to = "jump"}; }),
              HasSubstr("begins its state anew at once, forever"));
  EXPECT_EQ(refusal([](auto& m) {
              m.transitions = {{.from = "move", .to = "jump"}, {.from = "jump", .to = "move"}};
            }),
            "state \"move\" leads back to itself at once, forever: give a transition on the way a condition");
  EXPECT_THAT(refusal([](auto& m) { m.transitions[0].at_end = true; }), HasSubstr("an end that never comes"));
  EXPECT_THAT(refusal([](auto& m) { m.states[1].speed = 0.0; }), HasSubstr("an end that never comes"));
  EXPECT_THAT(refusal([](auto& m) { m.transitions[1].from = "*"; }), HasSubstr("so it leads from one state"));
}

TEST(StateMachine, RefusesMoreThanItHasRoomFor) {
  EXPECT_EQ(refusal([](auto& m) { m.inputs.resize(17); }), "a state machine has at most 16 inputs");
  EXPECT_EQ(refusal([](auto& m) { m.states.resize(65); }), "a state machine has at most 64 states");
  EXPECT_EQ(refusal([](auto& m) { m.transitions.resize(257); }), "a state machine has at most 256 transitions");
}

}  // namespace
}  // namespace throng::anim::state_machine_test
