#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test {

/// A square sheet of one material that fills the middle of the picture and faces the camera, which looks along -Z.
/// Nothing stands around it. The sun is behind the camera.
class Sheet {
 public:
  explicit Sheet(gl::Context& context);

  /// Draws it. Every pixel of the middle half of the picture shows the sheet.
  Image picture();

  /// The mean of a channel over the pixels around a place of the picture, from 0 to 1 to the right and down.
  static double brightness(const Image& image, float x, float y, int channel = 1);

  /// Lets light see its vertices as if they faced so.
  void face(const glm::vec3& normal);

  /// Turns it by half a turn about the direction in which it faces.
  void turn_upside_down();

  /// Lets all its vertices read every texture at one place.
  void read_at(float u, float v) { coords = all_at(u, v); }
  static std::vector<float> all_at(float u, float v);

  /// These two functions show the camera its back, or its front.
  void turn_around() { triangles_ = {0, 1, 2, 1, 3, 2}; }
  void turn_back() { triangles_ = {0, 2, 1, 1, 2, 3}; }

  /// Makes it a piece that somebody wears, with a tint and a second colour of this look.
  void dress(std::uint32_t tint, std::uint32_t second);
  /// Lets its pattern lie so: `coords` are metres then.
  void lay_out(float metres) { coords = {0, metres, metres, metres, 0, 0, metres, 0}; }

  MaterialData material;
  std::vector<ImageData> images;
  SceneLight light{.sun_elevation = 45.0F, .sun_azimuth = 0.0F, .clouds = 0.0F};
  std::vector<float> coords{0, 0, 1, 0, 0, 1, 1, 1};  ///< as an image lies: the top left corner comes first
  std::vector<float> metallic_roughness_coords, normal_coords, occlusion_coords;
  std::vector<float> colors;
  std::vector<float> tangents, trims, faces;
  std::uint8_t mesh_lod = 0;  ///< of a piece

 private:
  DollCrowd crowd_;
  bool is_dressed_ = false;
  std::vector<std::uint8_t> regions_;
  std::vector<float> normals_;
  std::array<std::uint32_t, 6> triangles_{0, 2, 1, 1, 2, 3};
};

/// A sheet on the software device, made anew for each test.
class SheetTest : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    sheet_ = std::make_unique<Sheet>(context());
  }
  void TearDown() override {
    sheet_.reset();
    SoftwareGlTest::TearDown();
  }

  Sheet& sheet() { return *sheet_; }
  MaterialData& material() { return sheet_->material; }

 private:
  std::unique_ptr<Sheet> sheet_;
};

}  // namespace throng::render::test
