#include "engine/render/mesh/packed_surface.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::render::packed_surface_test {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

/// Two vertices and the end of a bone at two bone levels, with two LODs of two and of one run.
Surface small_surface() {
  Surface surface;
  surface.vertices.resize(3);
  surface.vertices[1].position[0] = 2.5F;
  surface.detail_coords.resize(3);
  surface.detail_coords[1].occlusion = {2, 3};
  surface.tangents = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}};
  surface.entries = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 0, 0, 0}, {1, 1, 1, 1}, {5, 5, 5, 5}, {9, 0, 0, 0}};
  surface.indices = {0, 1, 0, 1, 0, 1, 0, 0, 1};
  surface.pieces = {{.first_lod = 0,
                     .runs_by_level = {{{0, 0, 3}, {1, 3, 3}}, {{1, 6, 3}}},
                     .triangles_by_level = {2, 1},
                     .error_by_level = {{}, {0.25F, 0.125F}}},
                    {.first_lod = 4,
                     .runs_by_level = {{{0, 0, 3}}, {{0, 3, 3}, {1, 6, 3}}},
                     .triangles_by_level = {1, 2},
                     .error_by_level = {{0.5F, 0.5F}, {0.75F, 0.5F}}},
                    {.first_lod = 0, .runs_by_level = {{}}, .triangles_by_level = {0}, .error_by_level = {{}}}};
  surface.vertex_count = 2;
  surface.first_bone_end = 2;
  surface.bone_end_count = 1;
  return surface;
}

/// The bytes of a packed surface where they may be read: on a multiple of 16.
class Aligned {
 public:
  explicit Aligned(const std::vector<std::byte>& bytes)
      : blocks_(bytes.size() / sizeof(Block) + 1), size_(bytes.size()) {
    if (size_ > 0) std::memcpy(blocks_.data(), bytes.data(), size_);
  }
  std::span<const std::byte> bytes() const { return std::as_bytes(std::span(blocks_)).first(size_); }

 private:
  struct alignas(16) Block {
    std::byte bytes[16];
  };
  std::vector<Block> blocks_;
  std::size_t size_;
};

bool same(const SurfaceVertex& a, const SurfaceVertex& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(PackedSurface, IsTheSurfaceThatWasPacked) {
  const Surface surface = small_surface();
  const Aligned packed(pack_surface(view_of(surface)));
  const Result<SurfaceView> view = view_packed_surface(packed.bytes());
  ASSERT_TRUE(view) << view.error().message;
  EXPECT_TRUE(std::ranges::equal(view->vertices, surface.vertices, same));
  ASSERT_EQ(view->detail_coords.size(), 3U);
  EXPECT_EQ(view->detail_coords[1].occlusion, surface.detail_coords[1].occlusion);
  EXPECT_THAT(view->tangents, ElementsAreArray(surface.tangents));
  EXPECT_THAT(view->entries, ElementsAreArray(surface.entries));
  EXPECT_THAT(view->indices, ElementsAreArray(surface.indices));
  ASSERT_EQ(view->pieces.size(), 3U);
  const SurfacePiece &whole = view->pieces[0], &piece = view->pieces[1];
  ASSERT_EQ(whole.runs_by_level.size(), 2U);
  EXPECT_EQ(whole.runs_by_level[0].size(), 2U);
  EXPECT_EQ(whole.runs_by_level[1][0].first_index, 6U);
  EXPECT_THAT(whole.triangles_by_level, ElementsAre(2U, 1U));
  EXPECT_THAT(whole.error_by_level, ElementsAre(MeshError{}, MeshError{0.25F, 0.125F}));
  EXPECT_EQ(piece.first_lod, 4U);
  EXPECT_THAT(piece.triangles_by_level, ElementsAre(1U, 2U));
  EXPECT_THAT(piece.error_by_level, ElementsAreArray(surface.pieces[1].error_by_level));
  ASSERT_EQ(piece.runs_by_level.size(), 2U);
  ASSERT_EQ(piece.runs_by_level[1].size(), 2U);
  EXPECT_EQ(piece.runs_by_level[1][1].first_index, 6U);
  EXPECT_EQ(view->pieces[2].runs_by_level.size(), 1U);
  EXPECT_EQ(view->vertex_count, 2U);
  EXPECT_EQ(view->first_bone_end, 2U);
  EXPECT_EQ(view->bone_end_count, 1U);
}

TEST(PackedSurface, IsReadWhereItLies) {
  const Aligned packed(pack_surface(view_of(small_surface())));
  const Result<SurfaceView> view = view_packed_surface(packed.bytes());
  ASSERT_TRUE(view);
  EXPECT_GE(static_cast<const void*>(view->vertices.data()), packed.bytes().data());
  EXPECT_LT(static_cast<const void*>(view->indices.data()), packed.bytes().data() + packed.bytes().size());
}

TEST(PackedSurface, IsRefusedCutShortOrOfAnotherVersion) {
  const std::vector<std::byte> bytes = pack_surface(view_of(small_surface()));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Aligned cut({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
    EXPECT_FALSE(view_packed_surface(cut.bytes())) << size;
  }
  std::vector<std::byte> other = bytes;
  other[3] ^= std::byte{4};  // of the layout
  EXPECT_THAT(view_packed_surface(Aligned(other).bytes()).error().message, HasSubstr("another version of throng"));
}

TEST(PackedSurface, IsRefusedWhereARunLeavesTheIndices) {
  Surface surface = small_surface();
  surface.pieces[0].runs_by_level[1][0].index_count = 4;
  const Aligned packed(pack_surface(view_of(surface)));
  EXPECT_THAT(view_packed_surface(packed.bytes()).error().message, HasSubstr("is damaged"));
}

TEST(PackedSurface, IsRefusedWhereAPieceHasNoLevel) {
  Surface surface = small_surface();
  surface.pieces[2] = {};
  const Aligned packed(pack_surface(view_of(surface)));
  EXPECT_THAT(view_packed_surface(packed.bytes()).error().message, HasSubstr("is damaged"));
}

}  // namespace
}  // namespace throng::render::packed_surface_test
