// Blocks are moved, looked at and changed by what knows nothing of their kind: total size and transforms offset do.

#include "tests/anim/entity/block_reader.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/entity_run.h"
#include "engine/anim/entity/player.h"

namespace throng::anim::block_reader_test {
namespace {

constexpr int bones = 20;

/// A block that a user derived from the animation state, with a private part of his own behind the transforms.
struct alignas(64) Tail {
  AnimationStateHeader state;
  float stiffness;
  float length;
};
static_assert(sizeof(Tail) <= 128);

std::size_t tail_links(int bone_count, int) { return static_cast<std::size_t>(bone_count) * 12; }
void rest(const EntityInStore& entity, const SourcesInStore&) { entity.as<Tail>().state.delta_time = Ticks{}; }
void keep(const EntityInStore&, const PacketJob&) {}
const EntityKind tail_kind = {.name = "tail",
                              .private_bytes_for = tail_links,
                              .keeps_transforms = true,
                              .advance = advance_each<rest>,
                              .pose_packet = keep};

struct Blocks {
  Blocks() : tails(pools.add_kind(tail_kind)) {
    for (const EntityPools::Kind kind :
         {EntityPools::Kind{EntityPools::keyframe_players}, EntityPools::Kind{EntityPools::ease_blenders}, tails}) {
      handles.push_back(pools.create(kind));
      const EntityLayout& layout = pools.layout(handles.back());
      std::byte* const block = pools.block(handles.back());
      for (std::uint32_t i = layout.private_offset; i < layout.total_size; ++i)
        block[i] = static_cast<std::byte>(i * 7);
      pools.state(handles.back()).linear_velocity[2] = 1.5F;
    }
    pools.as<Tail>(handles.back()).stiffness = 0.25F;
  }
  EntityPools pools{bones, rigid_components, Residency::resident};
  EntityPools::Kind tails;
  std::vector<Handle> handles;
};

struct Local {
  explicit Local(std::size_t size = 16384) : bytes(allocate_aligned(size)), span(bytes.get(), size) {}
  AlignedBytes bytes;
  std::span<std::byte> span;
};

TEST(BlockReader, MovesAnyBlockWhole) {
  Blocks blocks;
  for (const Handle handle : blocks.handles) {
    const Local local;
    const auto reader = BlockReader::fetch(blocks.pools.block(handle), local.span);
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->bytes().size(), blocks.pools.layout(handle).total_size);
    EXPECT_TRUE(std::ranges::equal(reader->bytes(), std::span(blocks.pools.block(handle), reader->bytes().size())));
    EXPECT_EQ(reader->state().linear_velocity[2], 1.5F);
  }
}

TEST(BlockReader, ReadsAndChangesTheTransformsOfAnyBlockAndNothingElse) {
  Blocks blocks;
  for (const Handle handle : blocks.handles) {
    const EntityLayout& layout = blocks.pools.layout(handle);
    std::byte* const block = blocks.pools.block(handle);
    const std::vector<std::byte> before(block, block + layout.total_size);
    const Local local;
    const auto reader = BlockReader::fetch(block, local.span);
    ASSERT_TRUE(reader->has_transforms());
    ASSERT_EQ(reader->pose().bone_count, bones);
    for (int bone = 0; bone < bones; ++bone) {
      EXPECT_EQ(reader->pose().rotation(bone), glm::quat(1.0F, 0.0F, 0.0F, 0.0F));
      reader->pose().set_position(bone, {0.0F, static_cast<float>(bone), 0.0F});
    }
    EXPECT_EQ(std::memcmp(block, before.data(), before.size()), 0) << "until it is put back";
    reader->put_back(block);
    const float* const transforms = transforms_of(blocks.pools.state(handle));
    EXPECT_EQ(transforms[(7 + 5) * packet_bones + 3], 19.0F) << "y of bone 19, in the second packet";
    EXPECT_EQ(std::memcmp(block, before.data(), layout.transforms_offset), 0);
    EXPECT_EQ(std::memcmp(block + layout.private_offset, before.data() + layout.private_offset, layout.private_bytes()),
              0);
  }
  EXPECT_EQ(blocks.pools.as<Tail>(blocks.handles.back()).stiffness, 0.25F);
}

TEST(BlockReader, MovesABlockToAnotherPlaceWhereItIsTheSame) {
  Blocks blocks;
  const Handle from = blocks.handles.back();
  const Handle to = blocks.pools.create(blocks.tails);
  const Local local;
  BlockReader::fetch(blocks.pools.block(from), local.span)->put_back(blocks.pools.block(to));
  EXPECT_EQ(blocks.pools.as<Tail>(to).stiffness, 0.25F);
  EXPECT_EQ(std::memcmp(blocks.pools.block(to), blocks.pools.block(from), blocks.pools.layout(to).total_size), 0);
}

TEST(BlockReader, SaysThatATransientBlockHasNoTransforms) {
  EntityPools pools(bones, rigid_components, Residency::transient);
  const Handle player = pools.create(EntityPools::sampled_players);
  const Local local;
  EXPECT_FALSE(BlockReader::fetch(pools.block(player), local.span)->has_transforms());
}

TEST(BlockReader, LeavesABlockThatDoesNotFitWhereItIs) {
  Blocks blocks;
  const Local local(1024);
  EXPECT_FALSE(BlockReader::fetch(blocks.pools.block(blocks.handles.front()), local.span));
}

}  // namespace
}  // namespace throng::anim::block_reader_test
