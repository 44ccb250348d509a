// A state machine as a text, and an agent that plays it, through the public headers.

#include "throng/state_machine.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::state_machine_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;
using testing::HasSubstr;

constexpr const char* person = R"({
  "inputs": [ {"name": "speed"}, {"name": "greet", "trigger": true}, {"name": "tired", "value": false} ],
  "states": [ {"name": "move", "by": "speed",
               "points": [ {"clip": "idle", "at": 0}, {"clip": "walk", "at": 1.4}, {"clip": "run", "at": 3.5} ]},
              {"name": "greet", "clip": "wave", "loop": false},
              {"name": "sit down", "clip": "sit down", "loop": false},
              {"name": "sit", "clip": "sit"},
              {"name": "stand up", "clip": "stand up", "loop": false} ],
  "transitions": [ {"from": "move", "to": "greet", "when": ["greet", "speed < 0.1"], "fade": 0.2},
                   {"from": "greet", "to": "move", "at_end": true, "fade": 0.2},
                   {"from": "move", "to": "sit down", "when": ["tired"], "fade": 0.25},
                   {"from": "sit down", "to": "sit", "at_end": true},
                   {"from": "sit", "to": "stand up", "when": ["not tired"], "fade": 0.1},
                   {"from": "stand up", "to": "move", "at_end": true, "fade": 0.2} ]
})";

/// One agent who plays the machine of a person.
class Person : public testing::Test {
 protected:
  Person() : machine_(*StateMachine::parse(person, mannequin())), body_(*crowd_.agent(0).add(machine_)) {}
  Machine body() { return {crowd_.agent(0), body_}; }
  std::string_view state() { return machine_.state_name(body().state()); }
  std::uint32_t input(const char* name) { return *machine_.find_input(name); }

  ApiCrowd crowd_{1};
  StateMachine machine_;
  ChannelId body_;
};

TEST_F(Person, MovesGreetsSitsAndStandsUp) {
  EXPECT_EQ(state(), "move");
  body().set(input("speed"), 2.0F);
  const Ticks before = crowd_->clock();
  crowd_.step(60);
  EXPECT_NEAR(crowd_.agent(0).motion().displacement(before, crowd_->clock()).displacement.z, 2.0, 0.05);
  body().fire(input("greet"));
  EXPECT_EQ(state(), "move") << "too fast for it";
  body().set(input("speed"), 0.0F);
  EXPECT_EQ(state(), "greet");
  crowd_.step(600);
  EXPECT_EQ(state(), "move");
  body().set(input("tired"), 1.0F);
  EXPECT_EQ(state(), "sit down");
  crowd_.step(600);
  EXPECT_EQ(state(), "sit");
  body().set(input("tired"), 0.0F);
  EXPECT_EQ(state(), "stand up");
  crowd_.step(600);
  EXPECT_EQ(state(), "move");
}

TEST_F(Person, IsInItsStateByTheClockThoughNobodyPosesIt) {
  body().set(input("tired"), 1.0F);
  const Ticks sits_at = mannequin().clip(mannequin().find_clip("sit down")).duration;
  crowd_->advance(sits_at + Ticks{1});
  EXPECT_EQ(state(), "sit");
  EXPECT_EQ(body().entered_at(), sits_at);
}

TEST_F(Person, PlaysThoughOthersPlayTheSameMachine) {
  crowd_->add_agents(50);
  for (const AgentId id : crowd_->agents().subspan(1)) {
    const Agent agent = crowd_->agent(id);
    const auto channel = agent.add(machine_);
    ASSERT_TRUE(channel);
    Machine(agent, *channel).set(input("tired"), static_cast<float>(id.number % 2));
  }
  crowd_.step(10);
  EXPECT_EQ(state(), "move");
}

TEST_F(Person, IgnoresWhatItIsNotToldRight) {
  const HeardMisuses heard;
  EXPECT_FALSE(body().set(17, 1.0F));
  EXPECT_FALSE(Machine(crowd_.agent(0), ChannelId{7}).set(0, 1.0F));
  EXPECT_EQ(Machine(crowd_.agent(0), ChannelId{7}).state(), 0U);
  EXPECT_FALSE(crowd_.agent(0).add(StateMachine()));
  EXPECT_EQ(HeardMisuses::all().size(), 4U);
  EXPECT_EQ(machine_.state_name(99), "");
  EXPECT_EQ(StateMachine().find_input("speed"), std::nullopt);
}

TEST(StateMachine, IsRefusedByAnAgentOfAnotherCharacter) {
  const HeardMisuses heard;
  CharacterBuilder builder("stranger");
  builder.add_bone({.name = "root"});
  for (std::uint32_t clip = 0; clip < mannequin().clip_count(); ++clip) builder.add_clip("clip", 1.0);
  Crowd crowd = std::move(*Crowd::create(builder.build()->characters.front()));
  const auto added = crowd.agent(crowd.add_agent()).add(*StateMachine::parse(person, mannequin()));
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().message, "Agent::add: the state machine was made for another character");
}

TEST(StateMachine, IsReadFromAFile) {
  const std::string path = testing::TempDir() + "state_machine_test.json";
  std::ofstream(path) << person;
  EXPECT_TRUE(StateMachine::load(path, mannequin()));
  std::ofstream(path) << R"({"states": [{"name": "fly", "clip": "fly"}]})";
  EXPECT_THAT(StateMachine::load(path, mannequin()).error().message,
              HasSubstr(path + ": state \"fly\" plays clip \"fly\", which "));
  EXPECT_FALSE(StateMachine::load(path + "x", mannequin()));
  EXPECT_THAT(StateMachine::parse("{", mannequin()).error().message, HasSubstr("is not JSON at line 1"));
}

}  // namespace
}  // namespace throng::state_machine_test
