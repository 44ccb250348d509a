#include "throng/render/lens.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "engine/base/srgb.h"
#include "engine/render/even_directions.h"

namespace throng::render {
namespace {

constexpr float half_film = 0.012F;  // metres

}  // namespace

float radius_of(const Lens& lens, const CameraView& view) {
  const float focal_length = half_film * view.projection[1][1];
  return 0.5F * focal_length / lens.aperture;
}

glm::vec2 point_of_disc(int index, int count) {
  const float radius = std::sqrt((static_cast<float>(index) + 0.5F) / static_cast<float>(count));
  const float angle = golden_angle * static_cast<float>(index);
  return radius * glm::vec2(std::cos(angle), std::sin(angle));
}

// A shift of the eye turns the view of a point `focus` ahead by shift / focus; the projection moves it back.
CameraView seen_through(const CameraView& view, const glm::vec2& aside, float focus) {
  CameraView seen = view;
  const glm::vec3 right(view.view[0][0], view.view[1][0], view.view[2][0]);
  const glm::vec3 up(view.view[0][1], view.view[1][1], view.view[2][1]);
  seen.position += aside.x * right + aside.y * up;
  seen.view[3][0] -= aside.x;
  seen.view[3][1] -= aside.y;
  seen.projection[2] -= (aside.x * view.projection[0] + aside.y * view.projection[1]) / focus;
  return seen;
}

void AveragedPicture::add(const Image& image) {
  if (count_++ == 0) {
    width_ = image.width;
    height_ = image.height;
    light_.assign(image.rgba.size() / 4, glm::vec3(0.0F));
  }
  assert(image.width == width_ && image.height == height_);
  const std::array<float, 256>& table = lights_of_srgb();
  for (std::size_t pixel = 0; pixel < light_.size(); ++pixel) {
    const std::uint8_t* const bytes = image.rgba.data() + 4 * pixel;
    light_[pixel] += glm::vec3(table.at(bytes[0]), table.at(bytes[1]), table.at(bytes[2]));
  }
}

Image AveragedPicture::finish() const {
  Image image = Image::blank(width_, height_);
  for (std::size_t pixel = 0; pixel < light_.size(); ++pixel) {
    const glm::vec3 light = light_[pixel] / static_cast<float>(count_);
    std::uint8_t* const bytes = image.rgba.data() + 4 * pixel;
    for (int channel = 0; channel < 3; ++channel) bytes[channel] = to_byte(srgb_of_light(light[channel]));
    bytes[3] = 255;
  }
  return image;
}

}  // namespace throng::render
