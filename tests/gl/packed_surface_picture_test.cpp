#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/render/mesh/packed_surface.h"
#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::packed_surface_picture_test {
namespace {

constexpr std::size_t crowd_size = 15;

/// Draws dolls of surfaces that are packed.
class PackedSurfacePicture : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    crowd_ = std::make_unique<DollCrowd>(context());
    crowd_->stand(crowd_size);
    crowd_->write_palettes();
  }
  void TearDown() override {
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  Status load(std::span<const std::byte> packed) {
    CrowdMeshData doll = crowd_->doll().mesh_data();
    doll.packed_surface = packed;
    const std::vector<CrowdMeshData> dolls(2, doll);
    return crowd_->renderer().load_characters(dolls);
  }
  std::vector<std::byte> packed() const { return pack_surface(view_of(build_surface(crowd_->doll().mesh_data()))); }
  Image picture() { return crowd_->picture(); }

 private:
  std::unique_ptr<DollCrowd> crowd_;
};

TEST_F(PackedSurfacePicture, IsThatOfTheSurfaceThatIsBuilt) {
  ASSERT_TRUE(load({}));
  const Image built = picture();
  const std::vector<std::byte> surface = packed();
  ASSERT_TRUE(load(surface));
  EXPECT_EQ(picture().rgba, built.rgba);
}

TEST_F(PackedSurfacePicture, IsRefusedOfADamagedSurface) {
  std::vector<std::byte> surface = packed();
  surface.resize(surface.size() - 16);
  EXPECT_FALSE(load(surface));
}

}  // namespace
}  // namespace throng::render::test::packed_surface_picture_test
