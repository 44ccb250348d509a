#include "app/settings/tuning_history.h"

#include <gtest/gtest.h>

namespace throng::app::tuning_history_test {
namespace {

struct Person {
  TuningHistory history;
  Tuning tuning;

  Person() { history.watch(tuning, false); }
  void set_agents(int agents, bool is_busy = false) {
    tuning.agents = agents;
    history.watch(tuning, is_busy);
  }
};

TEST(TuningHistory, TakesStepsBackAndMakesThemAgain) {
  Person person;
  person.set_agents(10);
  person.set_agents(20);
  EXPECT_TRUE(person.history.undo(person.tuning));
  EXPECT_EQ(person.tuning.agents, 10);
  EXPECT_TRUE(person.history.undo(person.tuning));
  EXPECT_EQ(person.tuning.agents, Tuning().agents);
  EXPECT_FALSE(person.history.undo(person.tuning));
  EXPECT_TRUE(person.history.redo(person.tuning));
  EXPECT_TRUE(person.history.redo(person.tuning));
  EXPECT_EQ(person.tuning.agents, 20);
  EXPECT_FALSE(person.history.redo(person.tuning));
}

TEST(TuningHistory, ADragIsOneStep) {
  Person person;
  for (int agents = 11; agents < 50; ++agents) person.set_agents(agents, true);
  person.set_agents(50);
  person.history.undo(person.tuning);
  EXPECT_EQ(person.tuning.agents, Tuning().agents);
}

TEST(TuningHistory, AnotherChangeForgetsWhatWasTakenBack) {
  Person person;
  person.set_agents(10);
  person.history.undo(person.tuning);
  person.set_agents(30);
  EXPECT_FALSE(person.history.can_redo());
}

TEST(TuningHistory, LeavesThePauseAlone) {
  Person person;
  person.set_agents(10);
  person.tuning.paused = true;
  person.history.watch(person.tuning, false);
  person.history.undo(person.tuning);
  EXPECT_TRUE(person.tuning.paused);
  EXPECT_EQ(person.tuning.agents, Tuning().agents);
  EXPECT_FALSE(person.history.can_undo());
}

TEST(TuningHistory, ValuesThatWereTakenAreNoStep) {
  Person person;
  person.tuning.agents = 77;
  person.history.take(person.tuning);
  person.history.watch(person.tuning, false);
  EXPECT_FALSE(person.history.can_undo());
}

TEST(TuningHistory, KeepsTheLastSteps) {
  Person person;
  for (int agents = 1; agents <= 300; ++agents) person.set_agents(agents);
  int steps = 0;
  while (person.history.undo(person.tuning)) ++steps;
  EXPECT_EQ(steps, static_cast<int>(TuningHistory::most_steps));
}

}  // namespace
}  // namespace throng::app::tuning_history_test
