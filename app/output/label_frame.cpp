#include "app/output/label_frame.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/character/roles.h"
#include "app/show/painter.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

using render::PixelBox;

constexpr float largest_variant = 1.15F;  // builds, frames and hair over the character's own surface
/// A joint lies no farther inside of a body, as a share of its height: a hip, seen from behind.
constexpr float deepest_joint = 0.14F;

glm::vec3 to_world(const render::InstanceRecord& record, const glm::vec3& place) {
  const float c = record.heading_cosine, s = record.heading_sine;
  const glm::vec3 turned(c * place.x + s * place.z, place.y, c * place.z - s * place.x);
  return glm::vec3(record.position[0], record.position[1], record.position[2]) + record.scale * turned;
}

glm::vec3 carried_by(const anim::PaletteMatrix& matrix, const glm::vec3& place) {
  const auto row = [&](const float(&r)[4]) { return r[0] * place.x + r[1] * place.y + r[2] * place.z + r[3]; };
  return {row(matrix.rows[0]), row(matrix.rows[1]), row(matrix.rows[2])};
}

/// Returns a box that holds the picture of a sphere.
PixelBox box_of_sphere(const LabelCamera& camera, glm::ivec2 size, const glm::vec3& middle, float radius) {
  const PixelBox whole{0, 0, size.x, size.y};
  const glm::vec3 seen(camera.to_camera * glm::vec4(middle, 1.0F));
  const float nearest = seen.z - radius, farthest = seen.z + radius;
  if (farthest <= render::Camera::near_distance) return {};
  if (nearest <= render::Camera::near_distance) return whole;
  const auto range = [&](float place, float focal, float centre) {
    const float low = place - radius, high = place + radius;
    return glm::vec2(centre + focal * low / (low < 0.0F ? nearest : farthest),
                     centre + focal * high / (high > 0.0F ? nearest : farthest));
  };
  const glm::vec2 x = range(seen.x, camera.focal.x, camera.middle.x);
  const glm::vec2 y = range(seen.y, camera.focal.y, camera.middle.y);
  const auto inside = [](float place, int side) {
    return static_cast<int>(std::clamp(place, 0.0F, static_cast<float>(side)));
  };
  return {inside(std::floor(x.x), size.x), inside(std::floor(y.x), size.y), inside(std::ceil(x.y), size.x),
          inside(std::ceil(y.y), size.y)};
}

}  // namespace

std::string id_of_agent(const Stage& stage, std::uint32_t agent) {
  const FollowedTracks* const tracks = stage.crowd().tracks();
  return tracks != nullptr ? tracks->people().trajectories().persons[agent].id : std::to_string(agent);
}

LabelCamera::LabelCamera(const render::CameraView& view, glm::ivec2 size) {
  const glm::mat4 turned(glm::vec4(1, 0, 0, 0), glm::vec4(0, -1, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 0, 0, 1));
  to_camera = turned * view.view;
  middle = 0.5F * glm::vec2(size);
  focal = middle * glm::vec2(view.projection[0][0], view.projection[1][1]);
}

glm::vec3 LabelCamera::project(const glm::vec3& place) const {
  const glm::vec3 seen(to_camera * glm::vec4(place, 1.0F));
  if (seen.z <= 0.0F) return {0.0F, 0.0F, seen.z};
  return {middle + focal * glm::vec2(seen) / seen.z, seen.z};
}

LabelMaker::LabelMaker(const Stage& stage) {
  for (const CharacterSource& source : stage.characters()) coco_.push_back(coco_points(source));
}

Status LabelMaker::make(Show& show, int number, bool is_drawn) {
  if (Status drawn = show.draw_labels(is_drawn, picture_); !drawn) return drawn;
  PaintedView view = show.view();
  view.frozen.reset();
  frame_.number = number;
  frame_.seconds = to_seconds(show.stage().system().clock());
  const Crowd& crowd = show.stage().crowd();
  frame_.file_seconds.reset();
  if (crowd.tracks() != nullptr) frame_.file_seconds = crowd.tracks()->clock().seconds;
  frame_.size = {view.width, view.height};
  frame_.camera = LabelCamera(render::view_of(view.camera, view.aspect()), frame_.size);
  find_seen_parts(show.stage().crowd().size());
  bound_bodies(show);
  if (Status measured = show.painter().measure_bodies(show.stage(), view, boxes_, bodies_); !measured) {
    return measured;
  }
  add_people(show);
  choose_scale();
  return Done{};
}

void LabelMaker::find_seen_parts(std::size_t agents) {
  seen_.assign(agents, {});
  for (int y = 0; y < picture_.size.y; ++y) {
    for (int x = 0; x < picture_.size.x; ++x) {
      const std::uint32_t label = picture_.agents[picture_.place(x, y)];
      if (label == 0) continue;
      SeenPart& part = seen_[label - 1];
      PixelBox& box = part.box;
      if (part.pixels++ == 0) box = {x, y, x + 1, y + 1};
      box.left = std::min(box.left, x);
      box.right = std::max(box.right, x + 1);
      box.bottom = y + 1;
    }
  }
}

void LabelMaker::bound_bodies(const Show& show) {
  boxes_.clear();
  for (const render::InstanceRecord& record : show.painter().picture().instances()) {
    PixelBox& box = boxes_.emplace_back();
    if (seen_[record.agent].pixels == 0) continue;
    const anim::CharacterBounds& bounds = show.stage().character_of(record.agent).character->bounds;
    const glm::vec3 middle = to_world(record, {0.0F, static_cast<float>(bounds.height) / 2.0F, 0.0F});
    const float radius = record.scale * largest_variant * static_cast<float>(bounds.reach);
    box = box_of_sphere(frame_.camera, frame_.size, middle, radius);
  }
  bodies_.resize(boxes_.size());
}

void LabelMaker::add_people(const Show& show) {
  frame_.people.clear();
  const auto instances = show.painter().picture().instances();
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (seen_[instances[i].agent].pixels == 0) continue;
    frame_.people.push_back(person(show.stage(), instances[i], bodies_[i]));
  }
  std::ranges::sort(frame_.people, {}, &LabelledPerson::agent);
}

LabelledPerson LabelMaker::person(const Stage& stage, const render::InstanceRecord& record,
                                  const render::BodyAlone& body) const {
  const std::uint32_t agent = record.agent;
  LabelledPerson person;
  person.agent = agent;
  person.id = id_of_agent(stage, agent);
  person.character = stage.crowd().characters()[agent];
  const Role role = stage.crowd().minds().roles()[agent];
  person.role = role == Role::other ? "other" : role_names.at(index_of(role));
  const int clip = stage.crowd().minds().clips()[agent];
  if (clip != no_clip) person.clip = stage.character_of(agent).clip_names[static_cast<std::size_t>(clip)];
  person.position = {record.position[0], record.position[1], record.position[2]};
  person.heading = std::atan2(record.heading_sine, record.heading_cosine);
  add_boxes(seen_[agent], body, person);
  add_points(stage, record, person);
  return person;
}

// Matrices of another picture round otherwise, so a pixel of an outline may be in one and not in the other.
void LabelMaker::add_boxes(const SeenPart& seen, const render::BodyAlone& body, LabelledPerson& person) {
  person.box = person.whole_box = seen.box;
  person.share_visible = 1.0;
  if (body.pixels == 0) return;
  person.whole_box = {std::min(body.box.left, seen.box.left), std::min(body.box.top, seen.box.top),
                      std::max(body.box.right, seen.box.right), std::max(body.box.bottom, seen.box.bottom)};
  const std::uint64_t pixels = std::max(body.pixels, seen.pixels);
  person.share_visible = static_cast<double>(seen.pixels) / static_cast<double>(pixels);
}

void LabelMaker::add_points(const Stage& stage, const render::InstanceRecord& record, LabelledPerson& person) const {
  const anim::Character& character = *stage.character_of(record.agent).character;
  const auto joints =
      stage.posed().joints().of(record.agent, static_cast<std::size_t>(character.skeleton.bone_count()));
  const float height = record.scale * static_cast<float>(character.bounds.height);
  for (const anim::PaletteMatrix& joint : joints) {
    person.joints.push_back(point(record, carried_by(joint, glm::vec3(0.0F)), height));
  }
  const CocoPoints& coco = coco_[person.character];
  for (std::size_t i = 0; i < coco.size(); ++i) {
    if (coco.at(i).bone < 0) continue;
    const anim::PaletteMatrix& joint = joints[static_cast<std::size_t>(coco.at(i).bone)];
    person.coco.at(i) = point(record, carried_by(joint, coco.at(i).place), height);
  }
}

LabelPoint LabelMaker::point(const render::InstanceRecord& record, const glm::vec3& place, float height) const {
  LabelPoint point{.place = to_world(record, place)};
  const glm::vec3 seen = frame_.camera.project(point.place);
  point.pixel = {seen.x, seen.y};
  const glm::ivec2 pixel(glm::floor(point.pixel));
  if (seen.z <= render::Camera::near_distance || !is_in_picture(pixel)) return point;
  point.seen = is_visible(record.agent + 1, pixel, seen.z, height) ? Seen::visible : Seen::hidden;
  return point;
}

bool LabelMaker::is_in_picture(glm::ivec2 pixel) const {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < frame_.size.x && pixel.y < frame_.size.y;
}

// A joint lies inside of its body, so its own body hides it only from far before it, as a chest hides an arm behind the
// back. A joint may stand out of an outline by a pixel.
bool LabelMaker::is_visible(std::uint32_t label, glm::ivec2 pixel, float metres, float height) const {
  const std::size_t at = picture_.place(pixel.x, pixel.y);
  if (picture_.agents[at] == label) return picture_.metres[at] >= metres - deepest_joint * height;
  if (picture_.metres[at] < metres) return false;
  for (int y = pixel.y - 1; y <= pixel.y + 1; ++y) {
    for (int x = pixel.x - 1; x <= pixel.x + 1; ++x) {
      if (is_in_picture({x, y}) && picture_.agents[picture_.place(x, y)] == label) return true;
    }
  }
  return false;
}

// The same steps serve most frames of a run, as they grow by halves of a decade or so.
void LabelMaker::choose_scale() {
  constexpr double most_steps = 65534;
  float farthest = 0.0F;
  for (std::size_t i = 0; i < picture_.agents.size(); ++i) {
    if (picture_.agents[i] != 0) farthest = std::max(farthest, picture_.metres[i]);
  }
  frame_.metres_a_step = 0.001;
  for (int step = 0; frame_.metres_a_step * most_steps < static_cast<double>(farthest); ++step) {
    frame_.metres_a_step *= step % 3 == 1 ? 2.5 : 2.0;  // 1, 2, 5, 10
  }
}

}  // namespace throng::app
