#include "engine/render/mesh/morph_table.h"

#include <gtest/gtest.h>

namespace throng::render::test::morph_table_test {
namespace {

TEST(MorphTable, HasTheEntriesOfEachVertexBesideEachOther) {
  const std::vector<MorphDeltaData> deltas{{.vertex = 1, .morph = 3, .position = {1, 2, 3}, .normal = {4, 5, 6}},
                                           {.vertex = 1, .morph = 5, .position = {7, 8, 9}, .normal = {}},
                                           {.vertex = 3, .morph = 0, .position = {}, .normal = {0, 0, 1}}};
  const MorphTable table = build_morph_table(deltas, 5);
  EXPECT_EQ(table.firsts, (std::vector<std::uint32_t>{0, 0, 2, 2, 3, 3}));
  ASSERT_EQ(table.entries.size(), 3U);
  EXPECT_EQ(table.entries[0].morph, 3U);
  EXPECT_EQ(table.entries[0].position[2], 3.0F);
  EXPECT_EQ(table.entries[0].normal[0], 4.0F);
  EXPECT_EQ(table.entries[1].morph, 5U);
  EXPECT_EQ(table.entries[2].normal[2], 1.0F);
}

TEST(MorphTable, OfASurfaceThatDoesNotMorphIsEmpty) {
  const MorphTable table = build_morph_table({}, 2);
  EXPECT_EQ(table.firsts, (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_TRUE(table.entries.empty());
}

}  // namespace
}  // namespace throng::render::test::morph_table_test
