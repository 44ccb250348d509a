#include "engine/render/light/sky_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "engine/render/even_directions.h"
#include "engine/render/light/atmosphere.h"
#include "engine/render/light/clouds.h"

namespace throng::render {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float daylight_exposure = 7.0F;
constexpr float adaptation = 0.8F;  // the share, in stops, of a darker scene that the eye makes up for
constexpr float brightest_adaptation = 60.0F;
constexpr float ground_albedo = 0.25F;

// The walls of a town, windows included, scatter this share of the light, and their roofs rise between these two slopes
// of a way that leads there. A high sun lights the ground rather than walls, so they count only under a low one.
constexpr glm::vec3 walls_albedo{0.54F, 0.45F, 0.35F};
constexpr float least_roof = 0.20F, most_roof = 0.50F;
constexpr float walls_share = 0.9F;
constexpr float sky_on_walls = 0.28F;  // of an open place's light, because walls stand opposite

constexpr glm::vec3 clearing{3.4e-4F, 4.3e-4F, 5.6e-4F};  // 1 / metres
constexpr float brightest_thick_haze = 1.0F;  // haze that is brighter would hide a crowd, so there is less of it

// Once the sun is down, the moon and a city give light. Exposed colours.
constexpr glm::vec3 moonlight{0.30F, 0.36F, 0.50F};
constexpr glm::vec3 night_zenith{0.016F, 0.028F, 0.072F}, night_horizon{0.100F, 0.100F, 0.135F};

float luminance(const glm::vec3& color) { return glm::dot(color, glm::vec3(0.2126F, 0.7152F, 0.0722F)); }

/// Calls `use(direction)` for directions that are spread evenly over the sphere.
constexpr int sphere_directions = 1600;
void for_each_direction(const auto& use) {
  for (int i = 0; i < sphere_directions; ++i) use(even_direction(i, sphere_directions));
}

std::size_t pixel_of(int x, int y, int side) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
}

glm::vec4 sample(const std::vector<glm::vec4>& map, int side, const glm::vec2& place) {
  const glm::vec2 at = glm::clamp(place * static_cast<float>(side) - 0.5F, 0.0F, static_cast<float>(side) - 1.0F);
  const glm::ivec2 low = glm::min(glm::ivec2(at), glm::ivec2(side - 2));
  const glm::vec2 f = at - glm::vec2(low);
  const auto pixel = [&](int x, int y) { return map[pixel_of(low.x + x, low.y + y, side)]; };
  return glm::mix(glm::mix(pixel(0, 0), pixel(1, 0), f.x), glm::mix(pixel(0, 1), pixel(1, 1), f.x), f.y);
}

void for_each_pixel(int side, const auto& use) {
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::vec2 place = (glm::vec2(x, y) + 0.5F) / static_cast<float>(side);
      use(pixel_of(x, y, side), place);
    }
  }
}

/// The noise of clouds in every pixel of the map. It is the same whatever the light.
const std::vector<float>& noise_of_map() {
  static const std::vector<float> noise = [] {
    std::vector<float> all(static_cast<std::size_t>(SkyPicture::side) * SkyPicture::side);
    for_each_pixel(SkyPicture::side, [&](std::size_t pixel, const glm::vec2& place) {
      all[pixel] = cloud_noise(cloud_place(sky_direction(place)), 6);
    });
    return all;
  }();
  return noise;
}

glm::vec3 face_direction(int face, const glm::vec2& place) {
  const float s = 2.0F * place.x - 1.0F, t = 2.0F * place.y - 1.0F;
  const glm::vec3 directions[] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
  return glm::normalize(directions[face]);
}

/// Returns the half vector of sample `i` around `normal` for a surface of that roughness (GGX).
glm::vec3 half_vector(const glm::vec3& normal, float roughness, int i, int count) {
  const float a = roughness * roughness, share = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
  const float rise = std::sqrt((1.0F - share) / (1.0F + (a * a - 1.0F) * share));
  const float flat = std::sqrt(1.0F - rise * rise), turn = golden_angle * static_cast<float>(i);
  const glm::vec3 side =
      glm::normalize(glm::cross(std::abs(normal.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), normal));
  return side * (flat * std::cos(turn)) + glm::cross(normal, side) * (flat * std::sin(turn)) + normal * rise;
}

}  // namespace

glm::vec2 sky_place(const glm::vec3& direction) {
  const glm::vec2 folded =
      glm::vec2(direction.x, direction.z) / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
  return 0.5F + 0.5F * glm::vec2(folded.x + folded.y, folded.y - folded.x);
}

glm::vec3 sky_direction(const glm::vec2& place) {
  const glm::vec2 at = 2.0F * place - 1.0F;
  const glm::vec2 folded(0.5F * (at.x - at.y), 0.5F * (at.x + at.y));
  return glm::normalize(glm::vec3(folded.x, 1.0F - std::abs(folded.x) - std::abs(folded.y), folded.y));
}

SkyPicture::SkyPicture(const SceneLight& light) {
  light_air(light);
  light_clouds(light);
  light_ground();
  sum_up();
}

void SkyPicture::light_air(const SceneLight& light) {
  const glm::vec3 to_sun = direction_at(light.sun_elevation, light.sun_azimuth);
  const Atmosphere air(to_sun);
  const float night = glm::smoothstep(5.0F, -6.0F, light.sun_elevation);
  coarse_.resize(static_cast<std::size_t>(coarse_side) * coarse_side);
  glm::vec3 sky(0.0F);
  for_each_pixel(coarse_side, [&](std::size_t pixel, const glm::vec2& place) {
    coarse_[pixel] = glm::vec4(air.radiance(sky_direction(place)), 1.0F);
    sky += glm::vec3(coarse_[pixel]);
  });
  sky *= 2.0F / static_cast<float>(coarse_.size());  // about the light that a white surface reflects of it, times pi
  const float key = luminance(air.sunlight()) * std::max(to_sun.y, 0.0F) + luminance(sky);
  constexpr float key_of_noon = 0.75F;
  const float adapted = std::min(std::pow(key_of_noon / std::max(key, 1e-6F), adaptation), brightest_adaptation);
  const float exposure = daylight_exposure * adapted * std::exp2(light.exposure);
  const float as_said = std::exp2(light.exposure);
  for_each_pixel(coarse_side, [&](std::size_t pixel, const glm::vec2& place) {
    const float height = std::sqrt(std::max(sky_direction(place).y, 0.0F));
    const glm::vec3 at_night = glm::mix(night_horizon, night_zenith, height) * (night * as_said);
    coarse_[pixel] = glm::vec4(glm::vec3(coarse_[pixel]) * exposure + at_night, 1.0F);
  });
  const bool moon = is_moonlit(light);
  const glm::vec3 sunlight = air.sunlight() * (exposure / pi);
  uniforms_.to_sun = to_brightest(light);
  uniforms_.night = night;
  uniforms_.sun_light = glm::vec4(moon ? moonlight * (night * as_said) : sunlight, 0.0F);
  cloud_sun_ = glm::vec3(uniforms_.sun_light);
  town_ = walls_share * glm::smoothstep(40.0F, 14.0F, light.sun_elevation) *
          glm::smoothstep(-2.0F, 4.0F, light.sun_elevation);
}

void SkyPicture::light_clouds(const SceneLight& light) {
  map_.resize(static_cast<std::size_t>(side) * side);
  const glm::vec2 towards_sun = glm::normalize(glm::vec2(uniforms_.to_sun.x, uniforms_.to_sun.z) + 1e-5F);
  const glm::vec3 shade = 0.5F * (glm::vec3(sample(coarse_, coarse_side, {0.5F, 0.5F})) +
                                  glm::vec3(sample(coarse_, coarse_side, {0.5F, 0.1F})));
  const glm::vec3 dull = glm::mix(shade, glm::vec3(luminance(shade)), 0.6F);
  for_each_pixel(side, [&](std::size_t pixel, const glm::vec2& place) {
    glm::vec4 color = sample(coarse_, coarse_side, place);
    const float noise = light.clouds > 0.0F ? noise_of_map()[pixel] : 0.0F;
    const float thickness = cloud_thickness(noise, light.clouds);
    if (thickness > 0.0F) {
      const glm::vec3 direction = sky_direction(place);
      const glm::vec2 on_layer = cloud_place(direction);
      const float relief = cloud_noise(on_layer, 3) - cloud_noise(on_layer + 0.22F * towards_sun, 3);
      const float lit = std::clamp(0.62F + 2.2F * relief, 0.0F, 1.0F) * (1.0F - 0.55F * thickness);
      const float cosine = std::max(glm::dot(direction, uniforms_.to_sun), 0.0F);
      const float lining = std::pow(cosine, 24.0F) * (1.0F - thickness);
      const glm::vec3 cloud = cloud_sun_ * (0.75F * lit + 1.2F * lining) + dull * (1.25F - 0.45F * thickness);
      const float seen = thickness * glm::smoothstep(0.0F, 0.20F, direction.y);
      color = glm::vec4(glm::mix(glm::vec3(color), cloud, seen), 1.0F - seen);
    }
    map_[pixel] = color;
  });
  // Behind closed clouds the sun gives no shadows; its light comes from everywhere.
  const float hidden = glm::smoothstep(0.7F, 1.0F, light.clouds);
  uniforms_.sun_light *= 1.0F - 0.97F * hidden;
  const float closed = 1.0F + 1.1F * hidden;
  for (glm::vec4& pixel : map_) pixel = glm::vec4(glm::vec3(pixel) * closed, pixel.a * (1.0F - hidden));
  for_each_pixel(coarse_side,
                 [&](std::size_t pixel, const glm::vec2& place) { coarse_[pixel] = sample(map_, side, place); });
}

void SkyPicture::light_ground() {
  glm::vec3 sky(0.0F), away(0.0F), towards(0.0F);
  for_each_direction([&](const glm::vec3& direction) {
    if (direction.y > 0.0F) sky += radiance(direction) * (direction.y * 4.0F / sphere_directions);
  });
  walls_in_shade_ = walls_albedo * sky_on_walls * sky;
  ground_in_shade_ = ground_albedo * sky;
  ground_ = ground_albedo * (sky + glm::vec3(uniforms_.sun_light) * std::max(uniforms_.to_sun.y, 0.0F));
  const glm::vec3 along = glm::normalize(glm::vec3(uniforms_.to_sun.x, 0.0F, uniforms_.to_sun.z) + 1e-5F);
  constexpr float low = 0.035F;
  for (const float turn : {-0.5F, 0.0F, 0.5F}) {
    const glm::vec3 aside(std::cos(turn) * along.x - std::sin(turn) * along.z, low,
                          std::sin(turn) * along.x + std::cos(turn) * along.z);
    towards += radiance(glm::normalize(aside)) / 3.0F;
    away += radiance(glm::normalize(glm::vec3(-aside.x, low, -aside.z))) / 3.0F;
  }
  uniforms_.haze = glm::vec4(away, along.x);
  uniforms_.haze_at_sun = glm::vec4(glm::max(towards - away, glm::vec3(0.0F)), along.z);
  const float bright = 0.5F * luminance(away + glm::max(towards, away));
  uniforms_.clearing = glm::vec4(clearing * std::min(brightest_thick_haze / bright, 1.0F), 0.0F);
}

glm::vec3 SkyPicture::radiance(const glm::vec3& direction) const {
  if (direction.y <= 0.0F) return ground_;
  const glm::vec4 light = sample(coarse_, coarse_side, sky_place(direction));
  return {light.r, light.g, light.b};
}

glm::vec3 SkyPicture::radiance_in_town(const glm::vec3& direction) const {
  const glm::vec3 open = radiance(direction);
  if (direction.y <= 0.0F) return glm::mix(open, ground_in_shade_, town_);
  const float hidden = town_ * glm::smoothstep(most_roof, least_roof, direction.y);
  if (hidden <= 0.0F) return open;
  const glm::vec3 facing = -glm::normalize(glm::vec3(direction.x, 0.0F, direction.z));
  const float lit = std::max(glm::dot(facing, uniforms_.to_sun), 0.0F);
  return glm::mix(open, walls_albedo * glm::vec3(uniforms_.sun_light) * lit + walls_in_shade_, hidden);
}

// Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001, with y up.
void SkyPicture::sum_up() {
  constexpr float zero = 0.282095F, one = 0.488603F, two = 1.092548F, polar = 0.315392F, square = 0.546274F;
  for_each_direction([&](const glm::vec3& n) {
    const glm::vec3 light = radiance_in_town(n) * (4.0F * pi / sphere_directions);
    const float basis[sky_harmonics] = {zero,
                                        one * n.y,
                                        one * n.z,
                                        one * n.x,
                                        two * n.x * n.y,
                                        two * n.y * n.z,
                                        polar * (3.0F * n.y * n.y - 1.0F),
                                        two * n.x * n.z,
                                        square * (n.z * n.z - n.x * n.x)};
    for (int i = 0; i < sky_harmonics; ++i) uniforms_.harmonics[i] += glm::vec4(light * basis[i], 0.0F);
  });
  // The cosine of a surface that scatters evenly keeps 1, 2/3 and 1/4 of the bands; the shader's polynomial leaves
  // out the factors of the basis.
  constexpr float kept[sky_harmonics] = {zero,    one * 2 / 3, one * 2 / 3, one * 2 / 3, two / 4,
                                         two / 4, polar / 4,   two / 4,     square / 4};
  for (int i = 0; i < sky_harmonics; ++i) uniforms_.harmonics[i] *= kept[i];
}

std::vector<glm::vec4> SkyPicture::environment(int face, int level) const {
  const int pixels = environment_side >> level;
  const float roughness = static_cast<float>(level) / (environment_levels - 1);
  const int samples = level == 0 ? 1 : 48;
  std::vector<glm::vec4> all(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels));
  for_each_pixel(pixels, [&](std::size_t pixel, const glm::vec2& place) {
    const glm::vec3 normal = face_direction(face, place);
    if (samples == 1) {
      all[pixel] = glm::vec4(radiance(normal), 1.0F);
      return;
    }
    glm::vec4 sum(0.0F);
    for (int i = 0; i < samples; ++i) {
      const glm::vec3 half = half_vector(normal, roughness, i, samples);
      const glm::vec3 direction = 2.0F * glm::dot(normal, half) * half - normal;
      const float facing = glm::dot(normal, direction);
      if (facing > 0.0F) sum += glm::vec4(radiance(direction), 1.0F) * facing;
    }
    all[pixel] = glm::vec4(glm::vec3(sum) / sum.a, 1.0F);
  });
  return all;
}

}  // namespace throng::render
