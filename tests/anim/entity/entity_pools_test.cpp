#include "engine/anim/entity/entity_pools.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace throng::anim::entity_pools_test {
namespace {

TEST(EntityPools, HaveNoRoomWhereOneKindHasTooLittleForAChannel) {
  constexpr std::uint32_t most_blocks = 100;
  EntityPools pools(20, 10, Residency::transient, most_blocks);
  std::uint32_t made = 0;
  for (; pools.has_room(); ++made) ASSERT_TRUE(pools.create(EntityPools::mixers).valid());
  EXPECT_GT(made, 0U);
  EXPECT_LT(made, most_blocks) << "a channel makes several entities before it asks again";
  for (; made < most_blocks; ++made) ASSERT_TRUE(pools.create(EntityPools::mixers).valid());
  EXPECT_FALSE(pools.create(EntityPools::mixers).valid());
  EXPECT_TRUE(pools.create(EntityPools::sampled_players).valid());
}

}  // namespace
}  // namespace throng::anim::entity_pools_test
