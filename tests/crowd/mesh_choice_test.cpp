// A budget of triangles is kept by coarser meshes where they are seen least.
#include "engine/crowd/mesh_choice.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace throng::mesh_choice_test {
namespace {

constexpr std::uint32_t agents = 5000;

/// Two characters, agents from 4 to 500 pixels tall in no order.
class MeshesWithinABudget : public testing::Test {
 protected:
  MeshesWithinABudget() {
    lods_.set(0, {{}, {0.004F, 0.002F}, {0.02F, 0.006F}, {0.06F, 0.06F}}, {6000, 3000, 700, 100});
    lods_.set(1, {{}, {0.01F, 0.02F}}, {2000, 400});
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      const std::uint32_t mixed = agent * 2654435761U >> 8U;
      visible_.push_back({.agent = agent,
                          .pixels_tall = 4.0F + 0.1F * static_cast<float>(mixed % 4961),
                          .interval = 1,
                          .bone_level = 0});
      character_of_.push_back(mixed % 3 == 0 ? 1 : 0);
    }
    choice_.reset(agents);
  }

  const MeshFigures& choose(int budget, int jobs = 1) {
    rules_.triangle_budget = static_cast<std::uint64_t>(budget);
    InOrder here;
    choice_.choose(visible_, character_of_, lods_, rules_, here, jobs);
    return choice_.figures();
  }
  std::vector<std::uint8_t> chosen() const { return {choice_.lods().begin(), choice_.lods().end()}; }
  std::uint64_t triangles() const {
    std::uint64_t sum = 0;
    for (std::size_t at = 0; at < visible_.size(); ++at) {
      sum += lods_.triangles(character_of_[at])[choice_.lods()[at]];
    }
    return sum;
  }
  float seen_px(std::size_t at, int lod) const {
    return lods_.seen_px(rules_, character_of_[at], lod, visible_[at].pixels_tall);
  }

  MeshLods lods_{2};
  MeshRules rules_;
  std::vector<anim::VisibleAgent> visible_;
  std::vector<std::uint8_t> character_of_;
  MeshChoice choice_;
};

TEST_F(MeshesWithinABudget, AreThoseOfTheErrorAloneWithoutOne) {
  const MeshFigures figures = choose(0);
  for (std::size_t at = 0; at < visible_.size(); ++at) {
    ASSERT_EQ(choice_.lods()[at], lods_.choose(rules_, character_of_[at], visible_[at].pixels_tall));
  }
  EXPECT_EQ(figures.triangles, triangles());
  EXPECT_EQ(figures.triangles_wanted, figures.triangles);
  EXPECT_EQ(figures.demoted, 0);
  EXPECT_TRUE(figures.budget_held);
}

TEST_F(MeshesWithinABudget, ArePickedUntilItHoldsAndNotFurther) {
  const std::uint64_t wanted = choose(0).triangles;
  const std::vector<std::uint8_t> before = chosen();
  for (const double share : {0.99, 0.7, 0.4, 0.15}) {
    const auto budget = static_cast<int>(share * static_cast<double>(wanted));
    const MeshFigures figures = choose(budget);
    EXPECT_EQ(figures.triangles, triangles());
    EXPECT_EQ(figures.triangles_wanted, wanted);
    EXPECT_TRUE(figures.budget_held);
    EXPECT_LE(figures.triangles, static_cast<std::uint64_t>(budget));
    EXPECT_GT(figures.triangles + 3000, static_cast<std::uint64_t>(budget)) << "no step more than are needed";
    std::uint32_t demoted = 0;
    for (std::size_t at = 0; at < before.size(); ++at) demoted += choice_.lods()[at] != before[at] ? 1U : 0U;
    EXPECT_EQ(figures.demoted, demoted);
    EXPECT_GT(demoted, 0U);
  }
}

TEST_F(MeshesWithinABudget, AreCoarserWhereThatIsSeenLeast) {
  const auto wanted = static_cast<double>(choose(0).triangles);
  const std::vector<std::uint8_t> before = chosen();
  choose(static_cast<int>(0.5 * wanted));
  float most_taken = 0.0F, least_left = 1e9F;
  for (std::size_t at = 0; at < before.size(); ++at) {
    const int lod = choice_.lods()[at], last = static_cast<int>(lods_.triangles(character_of_[at]).size()) - 1;
    if (lod > before[at]) most_taken = std::max(most_taken, seen_px(at, lod));
    if (lod < last) least_left = std::min(least_left, seen_px(at, lod + 1));
  }
  EXPECT_GT(most_taken, 0.0F);
  EXPECT_LE(most_taken, least_left * 1.125F) << "within an eighth of an octave the order is that of the agents";
  EXPECT_GT(choice_.figures().demoted_error_px, 0.5F);
  EXPECT_LE(choice_.figures().demoted_error_px, most_taken);
}

TEST_F(MeshesWithinABudget, AreAllTheCoarsestWhereItCannotHoldAndThatIsSaid) {
  const MeshFigures figures = choose(1000);
  EXPECT_FALSE(figures.budget_held);
  for (std::size_t at = 0; at < visible_.size(); ++at) {
    ASSERT_EQ(choice_.lods()[at] + 1U, lods_.triangles(character_of_[at]).size());
  }
}

TEST_F(MeshesWithinABudget, AreTheFixedOneWhereTheRulesHaveOne) {
  rules_.lod = 0;
  const MeshFigures figures = choose(1000);
  EXPECT_EQ(figures.demoted, 0);
  EXPECT_EQ(std::ranges::count(chosen(), 0), static_cast<std::ptrdiff_t>(agents));
}

TEST_F(MeshesWithinABudget, AreTheSameForAnyNumberOfJobs) {
  const auto budget = static_cast<int>(choose(0).triangles / 2);
  const MeshFigures alone = choose(budget);
  const std::vector<std::uint8_t> expected = chosen();
  for (const int jobs : {2, 3, 9}) {
    const MeshFigures figures = choose(budget, jobs);
    EXPECT_EQ(chosen(), expected) << jobs;
    EXPECT_EQ(figures.triangles, alone.triangles);
    EXPECT_EQ(figures.demoted, alone.demoted);
  }
}

TEST_F(MeshesWithinABudget, LoseTheFaceLast) {
  visible_.clear();
  for (std::uint32_t agent = 0; agent < 10; ++agent) {
    visible_.push_back({.agent = agent, .pixels_tall = 200.0F, .interval = 1, .bone_level = 0});
    character_of_[agent] = agent < 5 ? 1 : 0;
  }
  lods_.set(0, {{}, {0.03F, 0.002F}}, {6000, 700});  // off by 6 pixels, the face by less than half of one
  lods_.set(1, {{}, {0.01F, 0.02F}}, {2000, 400});   // off by 2 pixels, the face by 4
  choose(5 * 700 + 5 * 2000);
  EXPECT_EQ(chosen(), std::vector<std::uint8_t>({0, 0, 0, 0, 0, 1, 1, 1, 1, 1}));
  choose(1);
  EXPECT_EQ(std::ranges::count(chosen(), 1), 10) << "where nothing else helps, faces go too";
}

}  // namespace
}  // namespace throng::mesh_choice_test
