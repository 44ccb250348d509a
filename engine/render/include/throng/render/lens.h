#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "throng/render/crowd_draw.h"
#include "throng/render/image.h"

namespace throng::render {

/// The lens of a camera whose film is 24 mm high.
struct Lens {
  float focus = 5.0F;     ///< metres ahead of the camera, above 0: points there are sharp
  float aperture = 1.4F;  ///< the f-number, above 0; the smaller, the more is blurred
  int points = 32;        ///< of the lens, from each of which a picture is drawn
};

/// Returns the radius of the lens's opening, in metres. Its focal length follows from the camera's field of view.
float radius_of(const Lens& lens, const CameraView& view);

/// Returns point `index` of `count` on a disc of radius 1. The points lie evenly, each a golden angle from the last.
glm::vec2 point_of_disc(int index, int count);

/// Returns the view from beside the middle of a lens, `aside` metres to the right and up. What lies `focus` metres
/// ahead stays where it is in the picture.
CameraView seen_through(const CameraView& view, const glm::vec2& aside, float focus);

/// Averages pictures of one size as light does, not as numbers of sRGB.
class AveragedPicture {
 public:
  static constexpr std::uint64_t bytes_a_pixel = sizeof(glm::vec3) + 4;  ///< of the sums and of their average

  void add(const Image& image);
  /// Returns the average of the pictures, of which there is one at least.
  Image finish() const;

 private:
  int width_ = 0, height_ = 0, count_ = 0;
  std::vector<glm::vec3> light_;  // [pixel] sums
};

}  // namespace throng::render
