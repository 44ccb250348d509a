#include "engine/render/mesh/mesh_error.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace throng::render::mesh_error_test {
namespace {

constexpr float least = 0.002F;  // of the extent: what the samples resolve

/// Holds a surface under construction and a coarser one over the same vertices.
struct Scene {
  std::uint32_t add(const glm::vec3& position, const glm::vec3& color = glm::vec3(1.0F), float second_bone = 0.0F) {
    positions.insert(positions.end(), {position.x, position.y, position.z});
    influences.push_back({{0, 1, 0, 0}, {1.0F - second_bone, second_bone, 0.0F, 0.0F}});
    SurfaceVertex vertex{};
    for (int i = 0; i < 3; ++i) vertex.color[i] = static_cast<std::uint16_t>(color[i] * 65535.0F);
    vertex.color[3] = 65535;
    vertex.region = untinted_region;
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }

  /// Adds a flat square of cells by cells quads in the plane of y, which faces up.
  void add_floor(std::vector<std::uint32_t>& to, float from, float size, float y, int cells, const glm::vec3& color) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (int z = 0; z <= cells; ++z) {
      for (int x = 0; x <= cells; ++x) {
        const float step = size / static_cast<float>(cells);
        add({from + step * static_cast<float>(x), y, from + step * static_cast<float>(z)}, color);
      }
    }
    for (std::uint32_t z = 0; z + 1 < row; ++z) {
      for (std::uint32_t x = 0; x + 1 < row; ++x) {
        const std::uint32_t a = first + z * row + x, b = a + 1, c = a + row, d = c + 1;
        to.insert(to.end(), {a, c, b, b, c, d});
      }
    }
  }

  /// Adds a spike of four sides over the middle of the floor.
  void add_spike(std::vector<std::uint32_t>& to, float width, float height) {
    const float half = width / 2.0F;
    const std::uint32_t tip = add({0.5F, height, 0.5F});
    std::array<std::uint32_t, 4> ring{};
    constexpr std::array<std::array<float, 2>, 4> corners{{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}};
    for (std::size_t i = 0; i < 4; ++i) ring[i] = add({0.5F + corners[i][0] * half, 0.0F, 0.5F + corners[i][1] * half});
    for (std::size_t i = 0; i < 4; ++i) to.insert(to.end(), {ring[i], ring[(i + 1) % 4], tip});
  }

  float error() const { return error_between(full, coarse); }
  float error_between(const std::vector<std::uint32_t>& fine, const std::vector<std::uint32_t>& other) const {
    const std::vector<std::uint32_t> belongs_to(vertices.size(), 0);
    const std::vector<int> materials(vertices.size(), 0);
    CrowdMeshData data;
    data.materials.resize(1);
    Surface surface;
    surface.vertices = vertices;
    const SurfacePaint paint(surface, materials, data);
    const SkinnedSurfaceView view{positions, influences, belongs_to, fine, {}};
    return MeshErrorMeter(view, &paint, poses).error_of(other).surface;
  }

  std::vector<float> positions;
  std::vector<SkinInfluences> influences;
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> full, coarse;
  PosedPalettes poses;
};

constexpr glm::vec3 white(1.0F), black(0.0F);

TEST(MeshError, OfASurfaceAgainstItselfIsTheLeastThatSamplesResolve) {
  Scene scene;
  scene.add_floor(scene.full, 0.0F, 1.0F, 0.0F, 8, white);
  EXPECT_FLOAT_EQ(scene.error_between(scene.full, scene.full), least);
}

TEST(MeshError, OfTheSameShapeInFewerTrianglesIsTheLeast) {
  Scene scene;
  scene.add_floor(scene.full, 0.0F, 1.0F, 0.0F, 8, white);
  scene.add_floor(scene.coarse, 0.0F, 1.0F, 0.0F, 1, white);
  EXPECT_FLOAT_EQ(scene.error(), least);
}

// Half of the area of a spike 8 cm tall is within 2.3 cm of the floor: the rest is seen as long as it covers a patch as
// wide as it is off.
TEST(MeshError, CountsALostSpikeAndANewOne) {
  Scene scene;
  scene.add_floor(scene.full, 0.0F, 1.0F, 0.0F, 8, white);
  scene.coarse = scene.full;
  scene.add_spike(scene.full, 0.04F, 0.08F);
  EXPECT_GT(scene.error(), 0.025F);
  EXPECT_LT(scene.error(), 0.08F);
  EXPECT_GT(scene.error_between(scene.coarse, scene.full), 0.025F);
}

TEST(MeshError, LooksPastASpikeThinnerThanItCouldBeSeen) {
  Scene scene;
  scene.add_floor(scene.full, 0.0F, 1.0F, 0.0F, 8, white);
  scene.coarse = scene.full;
  scene.add_spike(scene.full, 0.0005F, 0.08F);
  EXPECT_LT(scene.error(), 0.012F);
}

// An eye 4 cm wide lies half a millimetre above the face.
TEST(MeshError, CountsALostEyeByItsSize) {
  Scene scene;
  scene.add_floor(scene.full, 0.0F, 1.0F, 0.0F, 20, white);
  scene.coarse = scene.full;
  scene.add_floor(scene.full, 0.48F, 0.04F, 0.0005F, 2, black);
  EXPECT_GT(scene.error(), 0.008F);
  EXPECT_LT(scene.error(), 0.04F);
}

TEST(MeshError, CountsAnEdgeOfColorByTheWayThatItMoved) {
  Scene scene;
  const auto halves = [&](std::vector<std::uint32_t>& to, float edge) {
    for (const auto& [from, until, color] : {std::tuple{0.0F, edge, white}, std::tuple{edge, 1.0F, black}}) {
      const std::uint32_t a = scene.add({from, 0, 0}, color), b = scene.add({until, 0, 0}, color);
      const std::uint32_t c = scene.add({from, 0, 1}, color), d = scene.add({until, 0, 1}, color);
      to.insert(to.end(), {a, c, b, b, c, d});
    }
  };
  halves(scene.full, 0.5F);
  halves(scene.coarse, 0.55F);
  EXPECT_NEAR(scene.error(), 0.045F, 0.01F);
}

// A closed box hides a wall in its middle.
TEST(MeshError, LooksPastWhatNobodySees) {
  Scene scene;
  const auto wall = [&](const glm::vec3& at, const glm::vec3& u, const glm::vec3& v) {
    const std::uint32_t a = scene.add(at), b = scene.add(at + u), c = scene.add(at + v), d = scene.add(at + u + v);
    scene.full.insert(scene.full.end(), {a, b, c, c, b, d});
  };
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  wall({0, 0, 0}, y, x);
  wall(z, x, y);
  wall({0, 0, 0}, z, y);
  wall(x, y, z);
  wall({0, 0, 0}, x, z);
  wall(y, z, x);
  scene.coarse = scene.full;
  wall({0, 0.5F, 0}, z, x);
  EXPECT_FLOAT_EQ(scene.error(), least);
  const std::vector<std::uint32_t> without_lid(scene.coarse.begin(), scene.coarse.end() - 6);
  EXPECT_GT(scene.error_between(scene.coarse, without_lid), 0.05F);
}

/// A straight strip whose far half the second bone moves. The coarse one has no vertices in the middle.
struct Strip : Scene {
  Strip() {
    constexpr int rows = 11;
    for (int row = 0; row < rows; ++row) {
      const float x = static_cast<float>(row) / (rows - 1);
      for (const float z : {0.0F, 0.2F}) add({x, 0.0F, z}, white, x > 0.45F ? 1.0F : 0.0F);
    }
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
      const std::uint32_t a = row * 2;
      full.insert(full.end(), {a, a + 1, a + 2, a + 2, a + 1, a + 3});
    }
    const std::uint32_t last = (rows - 1) * 2;
    coarse = {0, 1, last, last, 1, last + 1};
  }
};

TEST(MeshError, IsThatOfTheWorstPose) {
  Strip strip;
  const glm::mat4x3 rest(1.0F);
  const glm::mat4x3 bent(
      glm::translate(glm::rotate(glm::translate(glm::mat4(1), {0.5F, 0, 0}), 1.5F, {0, 0, 1}), glm::vec3(-0.5F, 0, 0)));
  strip.poses = {{rest, rest}};
  EXPECT_FLOAT_EQ(strip.error(), least);
  strip.poses.push_back({rest, bent});
  EXPECT_GT(strip.error(), 0.05F);
}

TEST(MeshError, OfNothingLeftIsAnEighthOfTheExtent) {
  Scene scene;
  scene.add_floor(scene.full, 0.0F, 1.0F, 0.0F, 8, white);
  EXPECT_FLOAT_EQ(scene.error(), 0.125F);
}

TEST(MeshError, IsANumberForTrianglesWithoutAreaAndCoordinatesThatAreNone) {
  Scene scene;
  scene.add_floor(scene.full, 0.0F, 1.0F, 0.0F, 4, white);
  scene.coarse = scene.full;
  scene.full.insert(scene.full.end(), {0, 0, 0, 1, 2, 1});
  for (SurfaceVertex& vertex : scene.vertices) vertex.texture_coord[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FLOAT_EQ(scene.error(), least);
}

}  // namespace
}  // namespace throng::render::mesh_error_test
