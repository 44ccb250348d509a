#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "tests/gl/doll_crowd.h"

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

  MaterialData material;
  std::vector<ImageData> images;
  SceneLight light{.sun_elevation = 45.0F, .sun_azimuth = 0.0F, .clouds = 0.0F};
  std::vector<float> coords{0, 0, 1, 0, 0, 1, 1, 1};  ///< as an image lies: the top left corner comes first
  std::vector<float> metallic_roughness_coords, normal_coords, occlusion_coords;
  std::vector<float> colors;
  std::vector<float> tangents;

 private:
  DollCrowd crowd_;
  std::vector<float> normals_;
};

}  // namespace throng::render::test
