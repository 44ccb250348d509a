#include "engine/anim/run/store_choice.h"

#include <utility>

#include <gtest/gtest.h>

namespace throng::anim {
namespace {

double milliseconds_of(StorePolicy policy, StorePolicy fastest) { return policy == fastest ? 1.0 : 2.0; }

/// Goes through the trials of a crowd.
void measure(StoreChoice& choice, std::size_t agents, StorePolicy fastest) {
  for (int update = 0; update < StoreChoice::policies * StoreChoice::trials; ++update) {
    choice.note(agents, milliseconds_of(choice.policy_for(agents), fastest));
  }
}

TEST(StoreChoice, TriesPlainAndPrefetchedStoresAndKeepsTheFaster) {
  for (const StorePolicy fastest : {StorePolicy::plain, StorePolicy::prefetched}) {
    StoreChoice choice;
    measure(choice, 1000, fastest);
    EXPECT_EQ(choice.policy_for(1000), fastest);
  }
}

TEST(StoreChoice, GoesByTheBestOfAPolicysTrials) {
  StoreChoice choice;
  bool cold = false;
  for (int update = 0; update < StoreChoice::policies * StoreChoice::trials; ++update) {
    const StorePolicy policy = choice.policy_for(100);
    const bool first = policy == StorePolicy::prefetched && !std::exchange(cold, policy == StorePolicy::prefetched);
    choice.note(100, first ? 50.0 : milliseconds_of(policy, StorePolicy::prefetched));
  }
  EXPECT_EQ(choice.policy_for(100), StorePolicy::prefetched);
}

TEST(StoreChoice, MeasuresAgainOnceTheCrowdHasMoreThanDoubledOrHalved) {
  StoreChoice choice;
  measure(choice, 1000, StorePolicy::prefetched);
  EXPECT_EQ(choice.policy_for(2000), StorePolicy::prefetched);
  EXPECT_EQ(choice.policy_for(500), StorePolicy::prefetched);
  EXPECT_EQ(choice.policy_for(2001), StorePolicy::plain) << "the first to be tried";
  measure(choice, 2001, StorePolicy::prefetched);
  EXPECT_EQ(choice.policy_for(2001), StorePolicy::prefetched);
}

TEST(StoreChoice, IsNotDisturbedByUpdatesOfAFew) {
  StoreChoice choice;
  measure(choice, 1000, StorePolicy::prefetched);
  EXPECT_EQ(choice.policy_for(1), StorePolicy::plain);
  choice.note(1, 0.001);
  EXPECT_EQ(choice.policy_for(1000), StorePolicy::prefetched);
}

}  // namespace
}  // namespace throng::anim
