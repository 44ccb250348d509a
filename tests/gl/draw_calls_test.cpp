// How many calls a picture of a crowd takes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/render/light/cascades.h"
#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::draw_calls_test {
namespace {

constexpr std::uint32_t of_no_character = 4;  // ground, sky, spots, and the map of how crowded it is

constexpr std::array<std::uint8_t, 8> half_clear = {255, 255, 255, 0, 255, 255, 255, 255};

/// Says how large a crowd is, and of what.
struct Crowd {
  std::size_t agents = 40;
  std::uint8_t characters = 1;
  std::uint32_t pages = 1;
  std::uint8_t lods = 1;
};

/// Dolls of three materials, one of them cut out.
class DrawCallsOfDolls : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    crowd_ = std::make_unique<DollCrowd>(context());
    CrowdMeshData doll = crowd_->doll().mesh_data();
    doll.parts.resize(3, doll.parts.front());
    for (int material = 0; material < 3; ++material) doll.parts[static_cast<std::size_t>(material)].material = material;
    doll.materials.resize(3);
    doll.materials[1].metallic = 1.0F;
    doll.materials[2].base_color_texture.image = 0;
    doll.materials[2].alpha_cutoff = 0.5F;
    const std::vector<float> coords(2 * crowd_->doll().vertex_count(), 0.75F);
    doll.parts[2].texture_coords = coords;
    doll.images = {{2, 1, half_clear}};
    const std::vector<CrowdMeshData> dolls(2, doll);
    ASSERT_TRUE(crowd_->renderer().load_characters(dolls));
    ASSERT_GE(crowd_->renderer().mesh_lods(0).errors.size(), 2U);
    crowd_->stand(1);
    crowd_->write_palettes();  // which makes the first page
    crowd_->renderer().palette_pages().add_page();
  }

  DrawCounts counts_of(const Crowd& crowd) {
    crowd_->instances.resize(crowd.agents, crowd_->instances.front());
    std::vector<CrowdBatch> batches;
    const auto runs = static_cast<std::uint32_t>(crowd.pages * crowd.characters * crowd.lods);
    const auto agents = static_cast<std::uint32_t>(crowd.agents);
    for (std::uint32_t run = 0; run < runs; ++run) {
      const std::uint32_t first = agents * run / runs;
      batches.push_back({.page = run / crowd.lods / crowd.characters,
                         .character = static_cast<std::uint8_t>(run / crowd.lods % crowd.characters),
                         .mesh_lod = static_cast<std::uint8_t>(run % crowd.lods),
                         .first = first,
                         .count = agents * (run + 1) / runs - first});
    }
    CrowdFrame frame = crowd_->frame();
    frame.batches = batches;
    frame.fill_pixels = false;
    return crowd_->renderer().draw(frame);
  }

 private:
  std::unique_ptr<DollCrowd> crowd_;
};

// Two opaque materials and a cut-out one: three calls on the screen, and two a shadow map.
constexpr std::uint32_t of_a_character = 3 + 2 * cascade_count;

TEST_F(DrawCallsOfDolls, AreOneAPassForEachPageCharacterAndMaterialHoweverManyAgentsAndLods) {
  for (const std::size_t agents : {std::size_t{8}, std::size_t{40}}) {
    for (const std::uint8_t lods : {std::uint8_t{1}, std::uint8_t{2}}) {
      for (const std::uint8_t characters : {std::uint8_t{1}, std::uint8_t{2}}) {
        for (const std::uint32_t pages : {1U, 2U}) {
          EXPECT_EQ(counts_of({agents, characters, pages, lods}).draw_calls,
                    of_no_character + pages * characters * of_a_character)
              << agents << " agents, " << int{lods} << " LODs, " << int{characters} << " characters, " << pages
              << " pages";
        }
      }
    }
  }
}

TEST_F(DrawCallsOfDolls, AreAtMostEightMoreWhereAProcessorDrawsACrowdInParts) {
  constexpr std::uint32_t most_parts = 8;
  const DrawCounts few = counts_of({400, 2, 2, 2}), many = counts_of({4000, 2, 2, 2});
  EXPECT_GT(many.triangles, 8 * few.triangles);
  EXPECT_GT(many.triangles, 100'000U);
  EXPECT_LE(many.draw_calls, of_no_character + 4 * of_a_character + most_parts);
}

}  // namespace
}  // namespace throng::render::test::draw_calls_test
