// A text of a state machine is read whole, or refused in a sentence. tests/anim/agent/channel tests what its names
// mean.

#include "engine/anim/import/machine/machine_file.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::import::machine_file_test {
namespace {

using ::testing::ElementsAre;
using Kind = anim::MachineDescription::Input::Kind;

constexpr const char* whole = R"({
  "inputs": [ {"name": "speed", "value": 0.5},
              {"name": "grounded", "value": true},
              {"name": "jump", "trigger": true} ],
  "start": "move",
  "states": [ {"name": "move", "by": "speed", "meaning": "plain", "points": [ {"clip": "idle", "at": 0}, {"clip": "run", "at": 3.5} ]},
              {"name": "aim", "by": ["x", "y"], "points": [ {"clip": "idle", "at": [-1, 2.5]} ]},
              {"name": "jump", "clip": "jump", "loop": false, "speed": 1.25} ],
  "transitions": [ {"from": "move", "to": "jump", "when": ["jump", "grounded"], "fade": 0.125},
                   {"from": "jump", "to": "move", "at_end": true, "after": 0.25} ]
})";

TEST(MachineFile, HasEveryMember) {
  const auto machine = read_machine(whole);
  ASSERT_TRUE(machine) << machine.error().message;
  EXPECT_EQ(machine->start, "move");
  ASSERT_EQ(machine->inputs.size(), 3U);
  EXPECT_EQ(machine->inputs[0].value, 0.5);
  EXPECT_EQ(machine->inputs[1].kind, Kind::flag);
  EXPECT_EQ(machine->inputs[1].value, 1.0);
  EXPECT_EQ(machine->inputs[2].kind, Kind::trigger);
  ASSERT_EQ(machine->states.size(), 3U);
  EXPECT_THAT(machine->states[0].by, ElementsAre("speed"));
  EXPECT_EQ(machine->states[0].meaning, "plain");
  EXPECT_EQ(machine->states[0].points[1].clip, "run");
  EXPECT_EQ(machine->states[0].points[1].at[0], 3.5);
  EXPECT_THAT(machine->states[1].by, ElementsAre("x", "y"));
  EXPECT_THAT(machine->states[1].points[0].at, ElementsAre(-1.0, 2.5));
  EXPECT_EQ(machine->states[2].clip, "jump");
  EXPECT_FALSE(machine->states[2].loop);
  EXPECT_EQ(machine->states[2].speed, 1.25);
  ASSERT_EQ(machine->transitions.size(), 2U);
  EXPECT_THAT(machine->transitions[0].when, ElementsAre("jump", "grounded"));
  EXPECT_EQ(machine->transitions[0].fade, 0.125);
  EXPECT_TRUE(machine->transitions[1].at_end);
  EXPECT_EQ(machine->transitions[1].after, 0.25);
}

std::string refusal_of(std::string_view text) {
  const auto machine = read_machine(text);
  return machine ? "(taken)" : machine.error().message;
}

TEST(MachineFile, SaysWhatIsWrongWithItsObjects) {
  EXPECT_EQ(refusal_of("[]"), "a state machine must be an object");
  EXPECT_EQ(refusal_of(R"({"state": []})"),
            R"(a state machine has an unknown key "state"; it knows inputs, start, states, transitions)");
  EXPECT_EQ(refusal_of(R"({"states": {}})"), R"(a state machine: "states" must be an array)");
  EXPECT_EQ(refusal_of(R"({"states": [7]})"), "state 0 must be an object");
  EXPECT_EQ(refusal_of(R"({"states": [{"name": 7}]})"), R"(state 0: "name" must be a text)");
  EXPECT_EQ(refusal_of(R"({"states": [{}, {"loop": 1}]})"), R"(state 1: "loop" must be true or false)");
  EXPECT_EQ(refusal_of(R"({"states": [{"by": 1}]})"),
            R"(state 0: "by" must be the name of an input, or an array of two)");
  EXPECT_EQ(refusal_of(R"({"states": [{"by": "speed", "points": [{"at": [1]}]}]})"),
            R"(state 0, point 0: "at" must be a number)");
  EXPECT_EQ(refusal_of(R"({"states": [{"by": ["x", "y"], "points": [{"at": 1}]}]})"),
            R"(state 0, point 0: "at" must be an array of two numbers)");
  EXPECT_EQ(refusal_of(R"({"inputs": [{"trigger": true, "value": 2}]})"),
            R"(input 0: "value" must be true or false for a trigger)");
  EXPECT_EQ(refusal_of(R"({"inputs": [{"value": "2"}]})"), R"(input 0: "value" must be a number, true or false)");
  EXPECT_EQ(refusal_of(R"({"transitions": [{"when": "jump"}]})"), R"(transition 0: "when" must be an array of texts)");
  EXPECT_EQ(refusal_of(R"({"transitions": [{"fade": "long"}]})"), R"(transition 0: "fade" must be a number)");
}

TEST(MachineFile, SaysWhereATextStopsBeingJson) {
  EXPECT_EQ(refusal_of("{\n  \"states\": [}"), "it is not JSON at line 2, column 14");
  EXPECT_EQ(refusal_of(std::string(100'000, '[')), "it is nested deeper than 64 levels");
}

TEST(MachineFile, BeginsErrorsWithTheNameOfTheFile) {
  const std::string folder = ::testing::TempDir();
  const std::string path = folder + "machine_file_test.json";
  EXPECT_EQ(read_machine_file(path).error().message, path + ": there is no such file; check the path");
  EXPECT_THAT(read_machine_file(folder).error().message,
              ::testing::HasSubstr(": it is a folder, not a file; name a .json"));
  std::ofstream(path) << "[]";
  EXPECT_EQ(read_machine_file(path).error().message, path + ": a state machine must be an object");
  std::ofstream(path) << whole;
  EXPECT_TRUE(read_machine_file(path));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace throng::import::machine_file_test
