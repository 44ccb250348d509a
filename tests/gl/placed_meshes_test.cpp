// Another size of one character of a cast, where the cast is drawn.
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "engine/render/mesh/mesh.h"

namespace throng::app::placed_meshes_test {
namespace {

std::unique_ptr<Show> show_of_three() {
  DemoOptions options;
  options.context = ContextKind::egl;
  options.force_software = true;
  options.width = options.height = 32;
  options.tuning.agents = 6;
  options.cast.assign(3, {.file = THRONG_SOURCE_DIR "/assets/mannequin.glb"});
  StartError error;
  auto show = open_show(options, error);
  EXPECT_NE(show, nullptr) << error.message;
  return show;
}

// Tells each mesh from those that are made later.
std::vector<const void*> meshes_of(Show& show) {
  std::vector<const void*> found;
  for (const render::CrowdMesh& mesh : show.painter().renderer().meshes()) {
    found.push_back(mesh.triangles_by_lod().data());
  }
  return found;
}

TEST(PlacedMeshes, OfTheOthersStay) {
  const auto show = show_of_three();
  const std::vector<const void*> before = meshes_of(*show);
  const auto seconds = show->take(SetPlacement{1, {.scale = 0.5}});
  ASSERT_TRUE(seconds) << seconds.error().message;
  const std::vector<const void*> after = meshes_of(*show);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_NE(after[1], before[1]);
  EXPECT_EQ(after[2], before[2]);
  show->animate(ticks_per_second / 60);
  EXPECT_TRUE(show->draw());
}

}  // namespace
}  // namespace throng::app::placed_meshes_test
