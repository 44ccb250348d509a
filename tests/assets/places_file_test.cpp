#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/places/finished_mesh.h"
#include "assets/places/glb.h"
#include "tests/assets/character_file.h"

namespace throng::test::places_file_test {
namespace {

using places::MadeLevel;
using places::MadeMesh;
using places::MadeVertex;

constexpr std::array house_bays{"arcade_bay", "facade_a", "facade_b", "facade_c", "facade_d", "facade_e"};

const std::vector<MadeMesh>& meshes() {
  static const std::vector<MadeMesh> all = [] {
    std::vector<MadeMesh> made;
    for (const places::Prop& prop : places::all_props()) made.push_back(places::finish(prop));
    return made;
  }();
  return all;
}

const MadeMesh& mesh_named(std::string_view name) {
  return *std::find_if(meshes().begin(), meshes().end(), [&](const MadeMesh& mesh) { return mesh.name == name; });
}

double metres(const MadeMesh& mesh, const MadeVertex& vertex, std::size_t axis) {
  return vertex.position[axis] * mesh.step;
}

std::pair<double, double> extent(const MadeMesh& mesh, std::size_t axis) {
  std::pair<double, double> found{1e9, -1e9};
  for (const MadeVertex& vertex : mesh.vertices) {
    found.first = std::min(found.first, metres(mesh, vertex, axis));
    found.second = std::max(found.second, metres(mesh, vertex, axis));
  }
  return found;
}

std::size_t triangles(const MadeLevel& level) { return level.indices.size() / 3; }

TEST(PlacesFile, IsWhatItsProgramWritesToTheByte) {
  const auto committed = CharacterFile::read(std::filesystem::path(THRONG_SOURCE_DIR) / "assets" / "places.glb");
  EXPECT_TRUE(places::write_glb(meshes()) == committed) << "regenerate assets/places.glb";
}

TEST(PlacesFile, HasEveryPropThatPlacesAreMadeOf) {
  std::set<std::string> names;
  for (const MadeMesh& mesh : meshes()) EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name << " is there twice";
  for (const char* name :
       {"arcade_bay", "arcade_corner", "facade_a",   "facade_b",      "facade_c", "facade_corner", "tower",
        "tree_a",     "tree_b",        "tree_c",     "planter",       "lamp",     "bench",         "fountain",
        "kiosk",      "steps",         "statue",     "flag",          "bunting",  "barrier",       "bollard",
        "stand",      "camera_crane",  "seat_block", "seat",          "roof_bay", "goal",          "flood_light",
        "banner",     "hill",          "skyline",    "skyline_center"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(PlacesFile, EveryLevelIsCoarserThanTheOneBefore) {
  for (const MadeMesh& mesh : meshes()) {
    EXPECT_EQ(mesh.levels.front().error, 0.0) << mesh.name;
    for (std::size_t level = 1; level < mesh.levels.size(); ++level) {
      EXPECT_LT(4 * triangles(mesh.levels[level]), 3 * triangles(mesh.levels[level - 1])) << mesh.name << " " << level;
      EXPECT_GT(mesh.levels[level].error, mesh.levels[level - 1].error) << mesh.name << " " << level;
    }
  }
}

TEST(PlacesFile, AHouseCostsLittleMoreThanAThousandTrianglesNearAndUnderSixtyFarOff) {
  for (const char* bay : house_bays) {
    EXPECT_LE(triangles(mesh_named(bay).levels.front()), 1150U) << bay;
    EXPECT_LT(triangles(mesh_named(bay).levels.back()), 60U) << bay;
  }
  for (const char* tree : {"tree_a", "tree_b", "tree_c"}) {
    EXPECT_LE(triangles(mesh_named(tree).levels.front()), 2500U) << tree;
    EXPECT_LT(triangles(mesh_named(tree).levels.back()), 50U) << tree;
  }
}

glm::dvec3 place_of(const MadeVertex& v) { return {v.position[0], v.position[1], v.position[2]}; }
glm::dvec3 normal_of(const MadeVertex& v) { return glm::dvec3(v.normal[0], v.normal[1], v.normal[2]) / 127.0; }

TEST(PlacesFile, NormalsHaveLengthOneAndPointOutOfTheirTriangles) {
  for (const MadeMesh& mesh : meshes()) {
    for (const MadeVertex& vertex : mesh.vertices) EXPECT_NEAR(glm::length(normal_of(vertex)), 1.0, 0.02) << mesh.name;
    for (const MadeLevel& level : mesh.levels) {
      for (std::size_t i = 0; i < level.indices.size(); i += 3) {
        std::array<const MadeVertex*, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c) corners[c] = &mesh.vertices[level.indices[i + c]];
        if (corners[0]->surface[2] > 0) continue;  // leaves share the light of their crown
        const glm::dvec3 a = place_of(*corners[0]);
        const glm::dvec3 across = glm::cross(place_of(*corners[1]) - a, place_of(*corners[2]) - a);
        if (glm::length(across) < 40) continue;  // rounding may turn what is that thin
        for (const MadeVertex* corner : corners) EXPECT_GT(glm::dot(normal_of(*corner), across), 0) << mesh.name;
      }
    }
  }
}

TEST(PlacesFile, PropsStandOnTheGround) {
  const std::set<std::string> hanging{"bunting"}, sunk{"seat_block", "hill"};
  for (const MadeMesh& mesh : meshes()) {
    const double low = extent(mesh, 1).first;
    if (sunk.contains(mesh.name)) continue;
    EXPECT_GE(low, -0.025) << mesh.name << " reaches into it by more than the end of a slanting bar";
    if (!hanging.contains(mesh.name)) {
      EXPECT_LE(low, 0.05) << mesh.name;
    }
  }
  EXPECT_EQ(extent(mesh_named("seat_block"), 1), std::make_pair(-1.0, 0.0));
}

/// The places (y, z) where a level's front, with all that stands out of it, meets the plane of an x.
std::set<std::pair<int, int>> outline_at(const MadeMesh& mesh, const MadeLevel& level, double x) {
  std::set<std::pair<int, int>> outline;
  for (const std::uint16_t index : level.indices) {
    const MadeVertex& vertex = mesh.vertices[index];
    if (metres(mesh, vertex, 0) == x && vertex.position[2] >= 0)
      outline.insert({vertex.position[1], vertex.position[2]});
  }
  return outline;
}

TEST(PlacesFile, BaysTileWithoutGapOrStep) {
  for (const char* bay : house_bays) {
    const MadeMesh& mesh = mesh_named(bay);
    EXPECT_EQ(extent(mesh, 0), std::make_pair(-3.0, 3.0)) << bay;
    EXPECT_LE(extent(mesh, 2).first, -7.5) << bay << " has the depth of a house behind its front";
    for (const MadeLevel& level : mesh.levels)
      EXPECT_EQ(outline_at(mesh, level, -3), outline_at(mesh, level, 3)) << bay;
  }
}

TEST(PlacesFile, ABenchIsAsHighAsPeopleSit) {
  const MadeMesh& bench = mesh_named("bench");
  double seat = 0;
  for (const MadeVertex& vertex : bench.vertices) {
    const bool on_seat = vertex.normal[1] > 120 && std::abs(metres(bench, vertex, 2)) < 0.23;
    if (on_seat && metres(bench, vertex, 1) < 0.5) seat = std::max(seat, metres(bench, vertex, 1));
  }
  EXPECT_NEAR(seat, 0.44, 0.001);
}

TEST(PlacesFile, SomeWindowsAreLitAtNightAndOthersAreNot) {
  for (const char* bay : house_bays) {
    const MadeMesh& mesh = mesh_named(bay);
    std::set<int> glows;  // of the windows between the shops and the roof
    for (const MadeVertex& vertex : mesh.vertices) {
      const double height = metres(mesh, vertex, 1);
      const bool glass = vertex.surface[3] == static_cast<std::uint8_t>(places::Kind::glass);
      if (glass && height > 6.5 && height < 12) glows.insert(vertex.surface[0]);
    }
    EXPECT_TRUE(glows.contains(0)) << bay;
    EXPECT_GE(glows.size(), 3U) << bay;
  }
}

TEST(PlacesFile, IsShadedByWhatIsNear) {
  // The same stone is darker at the foot of a pier than above.
  const MadeMesh& mesh = mesh_named("planter");
  int darkest = 255, brightest = 0;
  for (const std::uint16_t index : mesh.levels.front().indices) {
    const MadeVertex& vertex = mesh.vertices[index];
    if (vertex.surface[2] > 0 || metres(mesh, vertex, 1) > 0.58) continue;
    darkest = std::min<int>(darkest, vertex.colour[0]);
    brightest = std::max<int>(brightest, vertex.colour[0]);
  }
  EXPECT_LT(darkest, 0.8 * brightest);
}

}  // namespace
}  // namespace throng::test::places_file_test
