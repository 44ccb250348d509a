// Draws a figure with both mesh LODs at the moment at which one takes the other's place, from all around.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "throng/render/image.h"

#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "engine/crowd/mesh_lods.h"
#include "tests/gl/small_picture.h"

namespace throng::app::mesh_switch_test {
namespace {

using render::Image;

constexpr int width = 240, height = 240;
constexpr int views = 8;           // of an orbit around the figure
constexpr int smoothed = 1;        // pixels by which antialiasing spreads an outline
constexpr int color_step = 40;     // of 255: the light on a coarser mesh differs by less
constexpr int understated_by = 4;  // an error that is wrong by as much is found

DemoOptions one_figure(const std::string& model, bool dressed) {
  DemoOptions options = picture_by_processor(width, height);
  if (!model.empty()) options.models = {model};
  options.tuning.scene = Scene::grid;
  options.tuning.agents = 1;
  options.tuning.wardrobe = dressed;
  options.msaa = 4;
  options.tuning.scenery = options.tuning.shadows = options.tuning.crowd_shade = false;
  options.tuning.lod.rule = LodRule::off;
  return options;
}

/// Returns by how much a pixel leaves the colours that the other picture has within `reach` pixels of it.
int misfit(const Image& one, const Image& other, int x, int y, float reach) {
  const int around = static_cast<int>(reach);
  std::array<int, 3> least{255, 255, 255}, most{0, 0, 0};
  for (int down = std::max(y - around, 0); down <= std::min(y + around, height - 1); ++down) {
    for (int right = std::max(x - around, 0); right <= std::min(x + around, width - 1); ++right) {
      if (std::hypot(static_cast<float>(right - x), static_cast<float>(down - y)) > reach) continue;
      for (std::size_t part = 0; part < 3; ++part) {
        least.at(part) = std::min<int>(least.at(part), other.pixel(right, down)[part]);
        most.at(part) = std::max<int>(most.at(part), other.pixel(right, down)[part]);
      }
    }
  }
  int worst = 0;
  for (std::size_t part = 0; part < 3; ++part) {
    const int color = one.pixel(x, y)[part];
    worst = std::max({worst, least.at(part) - color, color - most.at(part)});
  }
  return worst;
}

/// Returns the largest mean misfit of a square of pixels as wide as `reach`: an error is as wide as the patch that has
/// it (MeshErrorMeter).
int worst_misfit(const Image& one, const Image& other, float reach) {
  const int wide = static_cast<int>(std::ceil(reach));
  std::vector<int> misfits;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      misfits.push_back(std::max(misfit(one, other, x, y, reach), misfit(other, one, x, y, reach)));
    }
  }
  int worst = 0;
  for (int y = 0; y + wide <= height; ++y) {
    for (int x = 0; x + wide <= width; ++x) {
      int sum = 0;
      for (int place = 0; place < wide * wide; ++place) {
        sum += misfits[static_cast<std::size_t>((y + place / wide) * width + x + place % wide)];
      }
      worst = std::max(worst, sum / (wide * wide));
    }
  }
  return worst;
}

/// Shows one figure at a moment of a clip.
class MeshSwitch : public testing::Test {
 protected:
  void begin(const std::string& model = {}, bool dressed = false) {
    show_.reset();  // The context of the last one made is the current one.
    StartError error;
    show_ = open_show(one_figure(model, dressed), error);
    ASSERT_NE(show_, nullptr) << error.message;
    for (int frame = 0; frame < 40; ++frame) show_->animate(to_ticks(1.0 / 60.0));
  }

  std::span<const render::MeshError> shares() const { return show_->stage().posed().mesh_lods().shares(0); }

  /// Draws the figure with a mesh LOD, `tall` pixels tall, from one of the views.
  Image picture(int lod, float tall, int view) {
    const float size = static_cast<float>(show_->stage().characters().front().character->bounds.height);
    const float away = render::pixels_tall(show_->view().camera, height, size, 1.0F) / tall;
    const float angle = 6.2831853F * static_cast<float>(view) / views, up = view % 2 == 0 ? 0.1F : 0.6F;
    show_->view().camera.yaw = angle;
    show_->view().camera.pitch = -up;
    show_->view().camera.position = show_->stage().crowd().positions()[0] + glm::vec3(0.0F, size / 2.0F, 0.0F) -
                                    away * render::forward(show_->view().camera);
    Tuning tuning = show_->stage().tuning();
    tuning.mesh_lod = lod;
    EXPECT_TRUE(show_->take(Apply{tuning}));
    show_->animate(Ticks{});
    EXPECT_TRUE(show_->draw());
    return show_->painter().renderer().read_image();
  }

  /// Returns how far pictures are apart at the switch to `lod`, which is made at `height_factor` times the height.
  int worst_at_switch(std::size_t lod, float limit, float height_factor = 1.0F) {
    const float tall = fine_below(shares()[lod], {.surface = limit, .face = std::min(limit, most_face_error)});
    int worst = 0;
    for (int view = 0; view < views; ++view) {
      const Image finer = picture(static_cast<int>(lod) - 1, tall * height_factor, view);
      const Image coarser = picture(static_cast<int>(lod), tall * height_factor, view);
      worst = std::max(worst, worst_misfit(finer, coarser, limit + smoothed));
    }
    return worst;
  }

  void expect_no_pop(float limit, int largest_step = color_step) {
    for (std::size_t lod = 1; lod < shares().size(); ++lod) {
      EXPECT_LE(worst_at_switch(lod, limit), largest_step) << "mesh " << lod << ", " << limit << " pixels";
    }
  }

 private:
  std::unique_ptr<Show> show_;
};

TEST_F(MeshSwitch, ChangesNoPixelByMoreThanTheLimit) {
  begin();
  expect_no_pop(0.5F);
  expect_no_pop(1.5F);
}

// A silhouette stands for outfits of another cut: the bare arm of somebody in a T-shirt is sleeved there.
TEST_F(MeshSwitch, ChangesLittleOfWhoDresses) {
  constexpr int color_step_of_outfit = 60;
  begin({}, true);
  expect_no_pop(0.5F, color_step_of_outfit);
  expect_no_pop(1.5F, color_step_of_outfit);
}

/// Returns characters of the folder that was named when the project was configured; none without one.
std::vector<std::string> imported_characters() {
  const std::string corpus = THRONG_CORPUS;
  if (corpus.empty()) return {};
  std::vector<std::string> files;
  for (const char* const file : {"CesiumMan.glb", "Soldier_packed.glb", "RobotExpressive.glb"}) {
    files.push_back(corpus + "/models/" + file);
  }
  return files;
}

class ImportedMeshSwitch : public MeshSwitch, public testing::WithParamInterface<std::string> {};

TEST_P(ImportedMeshSwitch, ChangesNoPixelByMoreThanTheLimit) {
  begin(GetParam());
  expect_no_pop(0.5F);
  expect_no_pop(1.5F);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ImportedMeshSwitch);
INSTANTIATE_TEST_SUITE_P(Corpus, ImportedMeshSwitch, testing::ValuesIn(imported_characters()));

TEST_F(MeshSwitch, IsSeenWhereAnErrorIsUnderstated) {
  begin();
  for (std::size_t lod = 1; lod < shares().size(); ++lod) {
    EXPECT_GT(worst_at_switch(lod, 1.5F, understated_by), color_step) << "mesh " << lod;
  }
}

}  // namespace
}  // namespace throng::app::mesh_switch_test
