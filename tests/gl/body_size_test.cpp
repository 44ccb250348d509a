#include <cstring>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/render/renderer.h"

#include "app/character/source.h"
#include "tests/gl/gl_test.h"
#include "tests/gl/skinning_read_back.h"

namespace throng::app::body_size_test {
namespace {

using render::test::ReadBackVertex;

class BodySize : public render::test::SoftwareGlTest {
 protected:
  // Returns the surface of somebody stout and stooped with long hair, whose model is that many times as large as its
  // file and is shown as large as a person.
  std::vector<ReadBackVertex> shown(double scale) {
    const auto source = load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin", nullptr,
                                       {.placement = {.scale = scale}});
    if (!source) return ADD_FAILURE() << source.error().message, std::vector<ReadBackVertex>();
    auto renderer = render::Renderer::create(context(), {.data = THRONG_SOURCE_DIR, .size = {8, 8}, .samples = 0});
    const render::CrowdMeshData mesh = mesh_data(*source);
    body_size = mesh.body_size;
    if (!renderer || !(*renderer)->load_characters({&mesh, 1})) return ADD_FAILURE(), std::vector<ReadBackVertex>();
    write_bind_pose((*renderer)->palette_pages().add_page(), source->model.skeleton.palette.size());
    render::InstanceRecord record{};
    record.scale = static_cast<float>(1.0 / scale);
    record.heading_cosine = 1.0F;
    render::AgentLook look = render::plain_look();
    look.shape = 0x7F7F7FU;
    look.hair = 0x7F7FU;
    const render::CrowdBatch batch{.count = 1};
    render::CrowdFrame frame;
    frame.instances = {&record, 1};
    frame.batches = {&batch, 1};
    frame.looks = {&look, 1};
    frame.looks_number = render::new_looks_number();
    return render::test::SkinningReadBack(**renderer).read(frame, {});
  }

  static void write_bind_pose(const render::PalettePage& page, std::size_t entries) {
    constexpr float identity[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    for (std::size_t i = 0; i < entries; ++i) {
      std::memcpy(page.memory + i * sizeof(identity), identity, sizeof(identity));
    }
  }

  float body_size = 0;
};

TEST_F(BodySize, BodiesDifferAsMuchWhetherTheyAreFiveCentimetresTallOrSeventyNineMetres) {
  const std::vector<ReadBackVertex> person = shown(1.0);
  EXPECT_EQ(body_size, 1.0F) << "exactly, so that no picture of people changes";
  for (const double scale : {0.03, 44.0}) {
    const std::vector<ReadBackVertex> other = shown(scale);
    EXPECT_NEAR(static_cast<double>(body_size), scale, 0.02 * scale);
    ASSERT_EQ(other.size(), person.size());
    float farthest = 0;
    for (std::size_t i = 0; i < person.size(); ++i) {
      farthest = std::max(farthest, glm::distance(other[i].position, person[i].position));
    }
    EXPECT_LT(farthest, 0.003F) << scale << ": half a pixel of one who is 300 pixels tall";
  }
}

}  // namespace
}  // namespace throng::app::body_size_test
