#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "assets/mannequin/body.h"
#include "assets/mannequin/glb.h"
#include "assets/mannequin/lod_error.h"
#include "engine/anim/import/import.h"
#include "tests/assets/character_file.h"

namespace throng::test::mannequin_lod_test {
namespace {

anim::Model imported() {
  auto file = import::import_file(std::string(THRONG_SOURCE_DIR) + "/assets/mannequin.glb");
  if (!file) throw std::runtime_error(file.error().message);
  EXPECT_TRUE(file->repairs.empty()) << "inspect has something to say: " << file->repairs.front();
  return std::move(file->models.front());
}

TEST(MannequinLods, ComeWithTheModelThatIsDrawn) {
  const anim::Model model = imported();
  EXPECT_EQ(model.meshes.size(), 1U);
  ASSERT_EQ(model.mesh_lods.size(), mannequin::mesh_lod_count);
  for (const anim::BakedMeshLod& lod : model.mesh_lods) EXPECT_EQ(lod.meshes.size(), 1U);
}

TEST(MannequinLods, AreSkinnedToTheBonesThatTheirLevelKeeps) {
  const anim::Model model = imported();
  const auto& kept = model.skeleton.level_bone_counts;
  ASSERT_EQ(kept.size(), 3U);
  for (std::size_t lod = 0; lod < mannequin::mesh_lod_count; ++lod) {
    const int bones = kept[std::min<std::size_t>(lod + 1, 2)];
    const anim::SkinnedMesh& mesh = model.mesh_lods[lod].meshes.front();
    std::set<std::string> dropped;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      for (int i = 0; i < 4; ++i) {
        const int bone = mesh.palette_entries[v][i];  // a rigid skeleton's palette has one entry a bone
        if (mesh.weights[v][i] <= 0 || bone < bones) continue;
        dropped.insert(model.skeleton.bones[static_cast<std::size_t>(bone)].name);
      }
    }
    EXPECT_EQ(dropped, std::set<std::string>{}) << "LOD " << lod + 1;
  }
}

TEST(MannequinLods, SayHowFarTheyAreFromTheFullSurfaceOverAllClips) {
  const mannequin::Body body = mannequin::make_body();
  const std::vector<mannequin::Clip> clips = mannequin::make_clips();
  const anim::Model model = imported();
  // Fingers that a bone level no longer moves are what is furthest off; on the whole the surface is where it was.
  constexpr std::array<double, mannequin::mesh_lod_count> largest{0.065, 0.115, 0.145};
  constexpr std::array<double, mannequin::mesh_lod_count> mean{0.003, 0.010, 0.013};
  for (std::size_t lod = 0; lod < mannequin::mesh_lod_count; ++lod) {
    const mannequin::SurfaceError error = mannequin::surface_error(body.full, body.lods[lod], clips);
    EXPECT_GE(model.mesh_lods[lod].error, error.largest);
    EXPECT_LT(model.mesh_lods[lod].error, error.largest + 2 * mannequin::error_step);
    EXPECT_LT(error.largest, largest[lod]);
    EXPECT_LT(error.mean, mean[lod]);
    std::printf("LOD %zu: %zu triangles, largest %.1f mm, mean %.2f mm\n", lod + 1, body.lods[lod].triangles.size(),
                error.largest * 1000, error.mean * 1000);
  }
}

TEST(MannequinLods, StandOutsideOfTheSceneThatOthersShow) {
  const CharacterFile file = CharacterFile::committed();
  EXPECT_EQ(file.json()["scene"], 0);
  EXPECT_EQ(file.json()["scenes"][0]["nodes"], (nlohmann::json{0, 62}));
  EXPECT_EQ(file.json()["scenes"][1]["nodes"], (nlohmann::json{0, 63, 64, 65}));
}

}  // namespace
}  // namespace throng::test::mannequin_lod_test
