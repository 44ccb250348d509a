#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/assets/character_file.h"

namespace throng::test::mannequin_body_test {
namespace {

/// Holds the triangles of the mesh, with vertices at one place taken as one.
class MannequinBody : public ::testing::Test {
 protected:
  MannequinBody() : positions_(file_.attribute("POSITION")) {
    std::map<std::array<double, 3>, std::size_t> places;
    for (std::size_t v = 0; v < positions_.size() / 3; ++v) {
      const std::array<double, 3> at{positions_[3 * v], positions_[3 * v + 1], positions_[3 * v + 2]};
      place_of_.push_back(places.try_emplace(at, places.size()).first->second);
    }
    place_count_ = places.size();
    for (const double index : file_.values(file_.primitive()["indices"])) {
      corners_.push_back(static_cast<std::size_t>(index));
    }
  }

  [[nodiscard]] std::size_t vertex_count() const { return place_of_.size(); }

  CharacterFile file_ = CharacterFile::committed();
  std::vector<double> positions_;
  std::vector<std::size_t> place_of_, corners_;
  std::size_t place_count_ = 0;
};

TEST_F(MannequinBody, IsOnePrimitiveOfOneMaterialOfAboutAsManyTrianglesAsItIsMeantToHave) {
  EXPECT_EQ(file_.json()["meshes"].size(), 1U);
  EXPECT_EQ(file_.json()["meshes"][0]["primitives"].size(), 1U);
  EXPECT_EQ(file_.json()["materials"].size(), 1U);
  EXPECT_GE(corners_.size() / 3, 4000U);
  EXPECT_LE(corners_.size() / 3, 6000U);
}

TEST_F(MannequinBody, IsClosedEveryEdgeSharedByTwoTrianglesOfOppositeSense) {
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    ++edges[{place_of_[corners_[c]], place_of_[corners_[next]]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST_F(MannequinBody, IsOnePiece) {
  std::vector<std::size_t> leader(place_count_);
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  const auto find = [&](std::size_t place) {
    while (leader[place] != place) place = leader[place] = leader[leader[place]];
    return place;
  };
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    leader[find(place_of_[corners_[c]])] = find(place_of_[corners_[next]]);
  }
  std::set<std::size_t> pieces;
  for (const std::size_t corner : corners_) pieces.insert(find(place_of_[corner]));
  EXPECT_EQ(pieces.size(), 1U);
}

TEST_F(MannequinBody, FacesOutwards) {
  double volume = 0;
  for (std::size_t t = 0; t < corners_.size(); t += 3) {
    std::array<glm::dvec3, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = corners_[t + i];
      p[i] = {positions_[3 * v], positions_[3 * v + 1], positions_[3 * v + 2]};
    }
    volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
  }
  EXPECT_GT(volume, 0.05);
  EXPECT_LT(volume, 0.11) << "cubic metres of a clothed adult";
}

TEST_F(MannequinBody, StandsOnTheGroundOneMetreEightyTall) {
  double low = 1;
  double high = 0;
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    low = std::min(low, positions_[3 * v + 1]);
    high = std::max(high, positions_[3 * v + 1]);
  }
  EXPECT_NEAR(low, 0, 1e-3);
  EXPECT_NEAR(high, 1.80, 0.015);
}

TEST_F(MannequinBody, IsTheSameLeftAndRight) {
  std::set<std::array<double, 3>> places;
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    places.insert({positions_[3 * v], positions_[3 * v + 1], positions_[3 * v + 2]});
  }
  for (const auto& [x, y, z] : places) EXPECT_TRUE(places.contains({-x, y, z})) << x << ' ' << y << ' ' << z;
}

TEST_F(MannequinBody, WeighsEveryVertexToExactlyOne) {
  const std::vector<double> weights = file_.attribute("WEIGHTS_0");
  const std::vector<double> joints = file_.attribute("JOINTS_0");
  ASSERT_EQ(weights.size(), 4 * vertex_count());
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    double sum = 0;
    std::set<double> used;
    for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
      EXPECT_GE(weights[i], 0);
      EXPECT_LT(joints[i], 62);
      sum += weights[i];
      const bool fresh = used.insert(joints[i]).second;
      EXPECT_TRUE(fresh || weights[i] == 0) << "vertex " << v << " names a joint twice";
    }
    EXPECT_EQ(sum, 1.0) << "vertex " << v;
  }
}

TEST_F(MannequinBody, MovesAsOneWhereRegionsMeet) {
  const std::vector<double> normals = file_.attribute("NORMAL");
  const std::vector<double> weights = file_.attribute("WEIGHTS_0");
  const std::vector<double> joints = file_.attribute("JOINTS_0");
  std::map<std::size_t, std::size_t> first;
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    const std::size_t twin = first.try_emplace(place_of_[v], v).first->second;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(normals[3 * v + i], normals[3 * twin + i]);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(weights[4 * v + i], weights[4 * twin + i]);
      EXPECT_EQ(joints[4 * v + i], joints[4 * twin + i]);
    }
  }
}

TEST_F(MannequinBody, GivesEveryTriangleOneOfFiveRegionsOrNone) {
  const std::vector<double> region = file_.attribute("_REGION");
  std::set<double> seen;
  for (std::size_t t = 0; t < corners_.size(); t += 3) {
    EXPECT_EQ(region[corners_[t]], region[corners_[t + 1]]);
    EXPECT_EQ(region[corners_[t]], region[corners_[t + 2]]);
    seen.insert(region[corners_[t]]);
  }
  EXPECT_EQ(seen, (std::set<double>{0, 1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace throng::test::mannequin_body_test
