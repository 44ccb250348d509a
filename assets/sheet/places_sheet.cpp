// throng_places_sheet FILE.png: what stands in the scenes, looked at from its best side and at its levels of detail.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "throng/render/camera.h"
#include "throng/render/renderer.h"

#include "app/people/place/props.h"
#include "assets/sheet/contact_sheet.h"

namespace throng::sheet {
namespace {

using render::Image;
using render::SceneryInstance;
using render::SceneryMeshData;

constexpr int portrait_pixels = 120;                          // eight in a row
constexpr std::uint32_t red = 0xFF3A40C8, blue = 0xFFB0683C;  // as SceneryInstance::tint has them

bool complain(const std::string& message) {
  std::fprintf(stderr, "throng_places_sheet: %s\n", message.c_str());
  return false;
}

/// The sheet is a tool of ours: it ends where the device fails.
void need(const Status& status) {
  if (!status) std::exit(complain(status.error().message) ? 0 : 1);
}

struct Ball {
  glm::vec3 centre{0.0F};
  float radius = 0.0F;
};

Ball bounds_of(const SceneryMeshData& mesh) {
  glm::vec3 low(1e9F), high(-1e9F);
  for (const render::SceneryVertex& vertex : mesh.vertices) {
    const glm::vec3 at(vertex.position[0], vertex.position[1], vertex.position[2]);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  return {0.5F * (low + high), 0.5F * glm::distance(low, high)};
}

glm::mat4x3 standing(glm::vec3 at, float turn = 0.0F, float size = 1.0F) {
  glm::mat4 place = glm::translate(glm::mat4(1.0F), at);
  place = glm::rotate(place, turn, glm::vec3(0.0F, 1.0F, 0.0F));
  return glm::mat4x3(glm::scale(place, glm::vec3(size)));
}

/// All levels of all props as meshes of one level each, so that a picture can show any.
class PropStudio {
 public:
  static std::unique_ptr<PropStudio> open() {
    std::unique_ptr<PropStudio> studio(new PropStudio);
    const std::string source = THRONG_SOURCE_DIR;
    auto props = app::read_props(source + "/assets/places.glb");
    if (!props) return complain(props.error().message), nullptr;
    auto context = render::gl::make_osmesa_context();
    if (!context) return complain(context.error().message), nullptr;
    studio->context_ = std::move(*context);
    auto renderer = render::Renderer::create(*studio->context_, {.data = source, .size = {64, 64}, .samples = 4});
    if (!renderer) return complain(renderer.error().message), nullptr;
    studio->renderer_ = std::move(*renderer);
    studio->load(*props);
    return studio;
  }

  std::size_t level_count(const std::string& name) const {
    std::size_t levels = 0;
    while (find(name, levels) < levels_.size()) ++levels;
    return levels;
  }

  void put(const std::string& name, const glm::mat4x3& place, std::uint32_t tint = render::no_tint,
           std::size_t level = 0) {
    const std::size_t mesh = find(name, level);
    if (mesh < levels_.size()) placed_.push_back({static_cast<std::uint32_t>(mesh), place, tint});
  }

  Ball bounds(const std::string& name) const { return bounds_of(levels_[find(name, 0)]); }

  /// Draws what was put, and takes it away.
  Image take(const render::Camera& camera, int width, int height, bool plain) {
    need(renderer_->set_size({width, height}));
    render::CrowdFrame frame;
    frame.camera = render::view_of(camera, static_cast<float>(width) / static_cast<float>(height));
    renderer_->draw(frame);
    const Image empty = renderer_->read_image();
    renderer_->place_scenery(placed_);
    frame.scenery = true;
    renderer_->draw(frame);
    Image picture = renderer_->read_image();
    if (plain) flatten_background(picture, empty);
    placed_.clear();
    return picture;
  }

 private:
  PropStudio() = default;

  void load(const std::vector<SceneryMeshData>& props) {
    for (const SceneryMeshData& prop : props) {
      for (std::size_t level = 0; level < prop.lods.size(); ++level) {
        levels_.push_back({level == 0 ? prop.name : prop.name + "." + std::to_string(level),
                           prop.vertices,
                           {{prop.lods[level].indices, 0.0F}}});
      }
    }
    need(renderer_->load_scenery(levels_));
  }

  std::size_t find(const std::string& name, std::size_t level) const {
    const std::string full = level == 0 ? name : name + "." + std::to_string(level);
    const auto found = std::ranges::find(levels_, full, &SceneryMeshData::name);
    return static_cast<std::size_t>(found - levels_.begin());
  }

  std::unique_ptr<render::gl::Context> context_;
  std::unique_ptr<render::Renderer> renderer_;
  std::vector<SceneryMeshData> levels_;
  std::vector<SceneryInstance> placed_;
};

std::uint32_t tint_of(const std::string& name) {
  if (name == "flag" || name == "banner") return red;
  return name == "seat" ? blue : render::no_tint;
}

/// One prop, turned a little, seen from a little above.
Image portrait(PropStudio& studio, const std::string& name, int size, std::size_t level = 0, float turn = 0.55F) {
  const Ball ball = studio.bounds(name);
  const glm::mat4 turned = glm::rotate(glm::mat4(1.0F), turn, glm::vec3(0.0F, 1.0F, 0.0F));
  const glm::vec3 centre(turned * glm::vec4(ball.centre, 1.0F));
  const float lifted = name == "seat_block" ? 1.0F : 0.0F;
  studio.put(name, standing({0.0F, lifted, 0.0F}, turn), tint_of(name), level);
  const bool flat = name == "steps" || name == "hill";
  render::Camera camera{.position = centre, .pitch = flat ? -0.45F : -0.16F, .vertical_view = 0.35F};
  const float ahead = 0.98F * ball.radius / std::sin(0.5F * camera.vertical_view);
  camera.position = centre + glm::vec3(0.0F, lifted, 0.0F) - ahead * render::forward(camera);
  return studio.take(camera, size, size, true);
}

void add_portraits(PropStudio& studio, ContactSheet& sheet) {
  const std::vector<std::vector<std::string>> rows{
      {"arcade_bay", "facade_a", "facade_b", "facade_c", "facade_d", "facade_e", "facade_corner", "arcade_corner"},
      {"tower", "tree_a", "tree_b", "tree_c", "fountain", "statue", "kiosk", "planter"},
      {"bench", "lamp", "bollard", "steps", "flag", "banner", "barrier", "bunting"},
      {"stand", "camera_crane", "roof_bay", "goal", "seat", "seat_block", "flood_light", "skyline_center"}};
  for (const std::vector<std::string>& row : rows) {
    std::vector<Image> pictures;
    pictures.reserve(row.size());
    for (const std::string& name : row) pictures.push_back(portrait(studio, name, portrait_pixels));
    sheet.add(beside(pictures));
  }
}

void add_levels(PropStudio& studio, ContactSheet& sheet) {
  std::vector<Image> pictures;
  for (const std::string name : {"facade_a", "tree_a"}) {
    for (std::size_t level = 0; level < std::min<std::size_t>(studio.level_count(name), 4); ++level) {
      pictures.push_back(portrait(studio, name, portrait_pixels, level));
    }
  }
  sheet.add(beside(pictures));
}

/// A corner of a street as who walks there sees it.
Image street(PropStudio& studio) {
  constexpr float quarter = std::numbers::pi_v<float> / 2.0F;
  const std::vector<std::string> houses{"facade_a", "facade_e", "facade_c", "facade_d", "facade_b"};
  const std::vector<std::uint32_t> tints{0xFFFFFFFF, 0xFFC8DCF4, 0xFFD8E6EC, 0xFFC4D8F8};
  for (std::size_t i = 0; i < 8; ++i) {
    const float z = -6.0F * static_cast<float>(i);
    studio.put(houses[i % 5], standing({-7.0F, 0.0F, z}, quarter), tints[i % 4], i < 4 ? 0 : 1);
    studio.put(houses[(i + i / 2 + 2) % 5], standing({7.0F, 0.0F, z}, -quarter), tints[(i + 2) % 4], i < 4 ? 0 : 1);
    studio.put("lamp", standing({-4.6F, 0.0F, z - 3.0F}));
    studio.put("bunting", standing({0.0F, 0.0F, 1.5F * z - 9.0F}));
    studio.put("tree_b", standing({4.5F, 0.0F, 1.4F * z - 8.0F}, z), render::no_tint, i < 2 ? 0 : 1);
  }
  studio.put("bench", standing({4.6F, 0.0F, -2.5F}, -quarter));
  studio.put("planter", standing({4.6F, 0.0F, -0.4F}));
  studio.put("kiosk", standing({-3.2F, 0.0F, -10.0F}, 0.9F));
  studio.put("tower", standing({0.0F, 0.0F, -60.0F}));
  const render::Camera camera{.position = {0.6F, 1.7F, 6.0F}, .yaw = 0.02F, .pitch = 0.12F, .vertical_view = 0.78F};
  return studio.take(camera, 8 * portrait_pixels, 350, false);
}

}  // namespace
}  // namespace throng::sheet

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fputs("throng_places_sheet: usage: throng_places_sheet FILE.png\n", stderr);
    return 2;
  }
  const auto studio = throng::sheet::PropStudio::open();
  if (!studio) return 1;
  throng::sheet::ContactSheet sheet;
  throng::sheet::add_portraits(*studio, sheet);
  throng::sheet::add_levels(*studio, sheet);
  sheet.add(throng::sheet::street(*studio));
  return sheet.write(arguments[1]) ? 0 : 1;
}
