#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/wardrobe/finish.h"
#include "tests/assets/worn_cloth.h"

namespace throng::test::wardrobe_cloth_test {
namespace {

using wardrobe::Body;
using wardrobe::Part;
using wardrobe::Slot;

bool is_cloth(const Part& part) {
  return part.slot == Slot::top || part.slot == Slot::bottom || part.slot == Slot::outer || part.slot == Slot::shoes;
}

std::vector<const Part*> clothes(Body body) {
  std::vector<const Part*> all;
  for (const Part& part : wardrobe::all_parts()) {
    if (is_cloth(part) && fits(part.bodies, body)) all.push_back(&part);
  }
  return all;
}

std::size_t count_of(Slot slot) {
  return static_cast<std::size_t>(std::count_if(wardrobe::all_parts().begin(), wardrobe::all_parts().end(),
                                                [&](const Part& part) { return part.slot == slot; }));
}

bool has(const std::vector<Slot>& slots, Slot slot) {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

/// Whether two garments are worn at once.
bool go_together(const Part& inner, const Part& outer) {
  if (inner.slot == outer.slot) return false;
  if (has(inner.keeps_out, outer.slot) || has(outer.keeps_out, inner.slot)) return false;
  const bool over_trousers = std::find(inner.tags.begin(), inner.tags.end(), "over_trousers") != inner.tags.end();
  return !over_trousers && !has(outer.covers, inner.slot);
}

/// Leaves out the triangles of a garment that a level does not have. The two may have other vertices at the same
/// points.
WornCloth with_triangles_of(WornCloth cloth, const mannequin::Mesh& made, const wardrobe::Level& level) {
  std::set<std::array<std::uint32_t, 3>> kept;
  const auto points = [](const mannequin::Mesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
    std::array<std::uint32_t, 3> all{mesh.vertices[a].point, mesh.vertices[b].point, mesh.vertices[c].point};
    std::sort(all.begin(), all.end());
    return all;
  };
  for (std::size_t i = 0; i < level.indices.size(); i += 3) {
    kept.insert(points(made, level.indices[i], level.indices[i + 1], level.indices[i + 2]));
  }
  std::erase_if(cloth.mesh.triangles,
                [&](const auto& t) { return !kept.contains(points(cloth.mesh, t[0], t[1], t[2])); });
  return cloth;
}

class WardrobeCloth : public ::testing::TestWithParam<Body> {};

TEST(Wardrobe, HasTwelveTopsTenBottomsAndSixPairsOfShoes) {
  EXPECT_GE(count_of(Slot::top) + count_of(Slot::outer), 12U);
  std::size_t dresses = 0;
  for (const Part& part : wardrobe::all_parts()) dresses += part.slot == Slot::top && has(part.covers, Slot::bottom);
  EXPECT_GE(count_of(Slot::bottom) + dresses, 10U);
  EXPECT_GE(count_of(Slot::shoes), 6U);
}

TEST_P(WardrobeCloth, HasTopsBottomsAndShoesForEveryBody) {
  std::set<Slot> slots;
  for (const Part* part : clothes(GetParam())) slots.insert(part->slot);
  EXPECT_EQ(slots.size(), 4U);
}

TEST_P(WardrobeCloth, IsMadeOfFewTriangles) {
  for (const Part* part : clothes(GetParam())) {
    const std::size_t triangles = worn_part(*part, GetParam()).mesh.triangles.size();
    EXPECT_GE(triangles, 200U) << part->name;
    EXPECT_LE(triangles, 2400U) << part->name;
  }
}

TEST_P(WardrobeCloth, KeepsSkinBelowIt) {
  constexpr double deepest = 0.010;
  std::vector<WornCloth> pieces;
  for (std::size_t s = 0; s < wardrobe::piece_count; ++s) {
    pieces.push_back(worn_skin(static_cast<Slot>(s), GetParam()));
  }
  for (const Part* part : clothes(GetParam())) {
    const WornCloth cloth = worn_part(*part, GetParam());
    for (std::size_t s = 0; s < pieces.size(); ++s) {
      if (has(part->covers, static_cast<Slot>(s)) || static_cast<Slot>(s) == Slot::head) continue;
      const CoveredCloth covered(pieces[s], cloth);
      if (covered.empty()) continue;
      for (const ClipMoment& moment : clip_moments()) {
        EXPECT_LE(covered.deepest(moment.pose), deepest)
            << pieces[s].name << " out of " << part->name << " in " << moment.clip << " at " << covered.place().x << ' '
            << covered.place().y << ' ' << covered.place().z;
      }
    }
  }
}

/// Collars lie on each other; they may come out further.
TEST_P(WardrobeCloth, KeepsWhatIsWornBelowItBelowIt) {
  constexpr double deepest = 0.010, deepest_collar = 0.010, seam_of_collars = 1.47;
  std::vector<WornCloth> worn;
  const std::vector<const Part*> parts = clothes(GetParam());
  for (const Part* part : parts) worn.push_back(worn_part(*part, GetParam()));
  for (std::size_t i = 0; i < worn.size(); ++i) {
    for (std::size_t o = 0; o < worn.size(); ++o) {
      if (worn[i].layer >= worn[o].layer || !go_together(*parts[i], *parts[o])) continue;
      for (const bool is_collar : {false, true}) {
        const CoveredCloth covered(worn[i], worn[o],
                                   is_collar ? Heights{.low = seam_of_collars} : Heights{.high = seam_of_collars});
        if (covered.empty()) continue;
        for (const ClipMoment& moment : clip_moments()) {
          EXPECT_LE(covered.deepest(moment.pose), is_collar ? deepest_collar : deepest)
              << worn[i].name << " out of " << worn[o].name << " in " << moment.clip << " at " << covered.place().x
              << ' ' << covered.place().y << ' ' << covered.place().z;
        }
      }
    }
  }
}

/// The rest of a top lies along the edges of a coat, where it is seen.
TEST_P(WardrobeCloth, LeavesOutWhatOuterClothesHide) {
  constexpr double deepest = 0.008, least_left = 0.25, most_left = 0.70;
  const std::vector<std::string> names{"t_shirt", "shirt", "jumper", "suit_jacket", "coat", "cardigan"};
  for (const wardrobe::Finished& finished : wardrobe::finish_wardrobe(names, false)) {
    const wardrobe::MadePart& made = *finished.made;
    if (made.slot != Slot::top) continue;
    ASSERT_FALSE(made.below.empty()) << made.name;
    const wardrobe::Level& left = made.below.front().levels.front();
    const auto share = static_cast<double>(left.indices.size()) / static_cast<double>(made.levels[0].indices.size());
    EXPECT_GT(share, least_left) << made.name;
    EXPECT_LT(share, most_left) << made.name;
    const WornCloth seen = with_triangles_of(worn_part(*made.part, GetParam()), made.mesh, left);
    for (const char* name : {"suit_jacket", "coat", "cardigan"}) {
      const Part* outer = wardrobe::find_part(name, GetParam());
      if (outer == nullptr) continue;
      const WornCloth cloth = worn_part(*outer, GetParam());
      const CoveredCloth covered(seen, cloth);
      double worst = 0;
      for (const ClipMoment& moment : clip_moments()) worst = std::max(worst, covered.deepest(moment.pose));
      EXPECT_LE(worst, deepest) << made.name << " out of " << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, WardrobeCloth, ::testing::Values(Body::man, Body::woman, Body::child),
                         [](const auto& body) { return std::string(name_of(body.param)); });

}  // namespace
}  // namespace throng::test::wardrobe_cloth_test
