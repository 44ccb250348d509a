#include "app/character/drawn_import.h"

#include <array>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/crowd/surface_data.h"

namespace throng::app::drawn_import_test {
namespace {

using testing::ElementsAre;

TEST(DrawnImport, HasAllChannelsOfTheWardrobe) {
  auto file = import_to_draw(THRONG_SOURCE_DIR "/assets/wardrobe.glb");
  ASSERT_TRUE(file) << file.error().message;
  std::array<std::set<std::size_t>, 5> widths;  // floats a vertex
  anim::visit_surfaces(file->models.front(), [&](const std::vector<anim::SkinnedMesh>& meshes) {
    for (const anim::SkinnedMesh& mesh : meshes) {
      const render::MeshPartData part = part_data(mesh, {});
      const std::array channels{part.shapes, part.hair, part.faces, part.trims, part.texture_coords};
      for (std::size_t i = 0; i < channels.size(); ++i) widths[i].insert(channels[i].size() / mesh.positions.size());
    }
  });
  EXPECT_THAT(widths,
              ElementsAre(ElementsAre(3), ElementsAre(0, 2), ElementsAre(0, 4), ElementsAre(0, 1), ElementsAre(0, 2)));
}

}  // namespace
}  // namespace throng::app::drawn_import_test
