#include "engine/anim/run/store/store_choice.h"

#include <bit>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::store_choice_test {
namespace {

TEST(StoreChoice, MeasuresTheMachineOnceWithinItsLimits) {
  const std::size_t measured = measured_cached_bytes();
  EXPECT_GE(measured, least_cached_bytes);
  EXPECT_TRUE(measured == any_bytes || (measured < most_measured_bytes && std::has_single_bit(measured)));
  EXPECT_EQ(measured_cached_bytes(), measured);
}

TEST(StoreChoice, IsTheLargestThatIsFasterWhereItLies) {
  const auto up_to = [](std::size_t most) {
    return measured_cached_bytes([=](std::size_t bytes) { return bytes <= most; });
  };
  EXPECT_EQ(up_to(0), least_cached_bytes);
  EXPECT_EQ(up_to(4 * least_cached_bytes), 4 * least_cached_bytes);
  EXPECT_EQ(up_to(most_measured_bytes), any_bytes) << "a machine that writes slowly past its caches";
}

TEST(StoreChoice, FetchesWhatStaysInTheCachesAndWritesPastThemWhatDoesNot) {
  EXPECT_EQ(store_policy_for(0, 0), StorePolicy::prefetched);
  EXPECT_EQ(store_policy_for(least_cached_bytes / 5 * 4, 0), StorePolicy::prefetched);
  constexpr std::size_t cached = 4 * least_cached_bytes;
  EXPECT_EQ(store_policy_for(cached / 5 * 4, cached), StorePolicy::prefetched);
  EXPECT_EQ(store_policy_for(cached, cached), StorePolicy::streaming) << "with blocks and streams it is more";
  EXPECT_EQ(store_policy_for(most_measured_bytes, any_bytes), StorePolicy::prefetched);
}

TEST(StoreChoice, FollowsTheSizeOfTheCrowd) {
  CrowdRig crowd({.cached_bytes = least_cached_bytes}, 1);
  EXPECT_EQ(crowd->figures().schedule().stores, StorePolicy::prefetched);
  const std::size_t palette_bytes = static_cast<std::size_t>(test_character()->skeleton.palette_count()) * 48;
  crowd->add_agents(static_cast<std::uint32_t>(most_measured_bytes / palette_bytes), 0);
  EXPECT_EQ(crowd->figures().schedule().stores, StorePolicy::streaming);
  crowd->set_agent_count(0);
  EXPECT_EQ(crowd->figures().schedule().stores, StorePolicy::prefetched);
}

TEST(StoreChoice, IsTheHostsWhereItSaysSo) {
  for (const StorePolicy stores : {StorePolicy::plain, StorePolicy::prefetched, StorePolicy::streaming}) {
    const CrowdRig crowd({.stores = stores}, 1);
    EXPECT_EQ(crowd->figures().schedule().stores, stores);
  }
}

TEST(StoreChoice, ChangesNoBitOfAPalette) {
  constexpr std::uint32_t agents = 21;
  const auto played = [](StorePolicy stores) {
    CrowdRig crowd({.stores = stores}, agents);
    for (std::uint32_t agent = 0; agent < agents; ++agent)
      crowd->agent(agent).play({.clip = static_cast<int>(agent % 5)});
    crowd.step(3);
    return crowd;
  };
  const CrowdRig plain = played(StorePolicy::plain);
  for (const StorePolicy stores : {StorePolicy::prefetched, StorePolicy::streaming}) {
    const CrowdRig other = played(stores);
    for (std::uint32_t agent = 0; agent < agents; ++agent) EXPECT_TRUE(other.bones_unlike(plain, agent).empty());
  }
}

}  // namespace
}  // namespace throng::anim::store_choice_test
