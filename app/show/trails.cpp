#include "app/show/trails.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"
#include "app/settings/agent_colors.h"
#include "app/show/stage/stage.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {
namespace {

constexpr double step_seconds = 0.2;      // between places that are kept
constexpr float above_ground = 0.02F;     // metres
constexpr float most_off_px = 0.5F;       // of a line from the way that it stands for
constexpr float pieces_of_fading = 8.0F;  // of a trail, at least, where each is a few pixels long
constexpr float least_piece_px = 8.0F;
constexpr float nearest_camera = 2.0F;  // metres
constexpr std::uint32_t plain_color = 0x00E8F0F2, no_alpha = 0x00FFFFFF;

std::uint32_t faded(std::uint32_t color, float age, float seconds) {
  const float left = std::clamp(1.0F - age / seconds, 0.0F, 1.0F);
  return (color & no_alpha) | static_cast<std::uint32_t>(255.0F * std::sqrt(left)) << 24U;
}

glm::vec2 on_map(const glm::vec3& place) { return {place.x, place.z}; }

/// Says how far a line can go straight on without leaving a passed point farther aside than a width: the directions
/// that are left after each point (as J. Sklansky and V. Gonzalez, "Fast polygonal approximation of digitized curves",
/// 1980).
class Straight {
 public:
  explicit Straight(const glm::vec2& from, float width) : from_(from), width_(width) {}

  bool passes(const glm::vec2& place) {
    const glm::vec2 way = place - from_;
    const float length = glm::length(way);
    const bool turns_back = length < farthest_ - width_;
    if (turns_back || (is_bound_ && (cross(right_, way) < 0.0F || cross(way, left_) < 0.0F))) return false;
    farthest_ = std::max(farthest_, length);
    if (length <= width_) return true;
    const glm::vec2 aside = (width_ / length) * glm::vec2(-way.y, way.x), left = way + aside, right = way - aside;
    if (!is_bound_ || cross(left, left_) > 0.0F) left_ = left;
    if (!is_bound_ || cross(right_, right) > 0.0F) right_ = right;
    is_bound_ = true;
    return true;
  }

 private:
  glm::vec2 from_, left_{0.0F}, right_{0.0F};
  float width_, farthest_ = 0.0F;
  bool is_bound_ = false;
};

}  // namespace

/// Says which points a person who looks at the picture can see.
struct Trails::View {
  std::array<glm::vec4, 6> planes;
  glm::vec3 camera;
  float metres_a_pixel;  // a metre ahead
};

// Steps may be counted below 0, as a file's clock may.
glm::vec3& Trails::place_at(std::size_t agent, std::int64_t step) {
  const auto count = static_cast<std::int64_t>(places_a_person_);
  return places_[agent * places_a_person_ + static_cast<std::size_t>((step % count + count) % count)];
}

bool Trails::make_room(const Stage& stage) {
  seconds_ = stage.tuning().trail_seconds;
  if (seconds_ <= 0.0F) return false;
  const auto wanted = static_cast<std::size_t>(std::ceil(static_cast<double>(seconds_) / step_seconds)) + 1;
  const std::size_t people = stage.crowd().size();
  if (crowd_ == stage.animated().number() && wanted == places_a_person_ && kept_.size() == people) return true;
  crowd_ = stage.animated().number();
  places_a_person_ = wanted;
  places_.resize(people * wanted);
  kept_.assign(people, Kept{});
  points_.reserve(wanted + 2);
  return true;
}

void Trails::keep_up(const Followers& followers, std::size_t agent, double seconds) {
  const auto end = static_cast<std::int64_t>(std::floor(seconds / step_seconds)) + 1;
  const Kept now{end - static_cast<std::int64_t>(places_a_person_), end}, before = std::exchange(kept_[agent], now);
  for (std::int64_t step = now.first; step < end; ++step) {
    const bool is_kept = step >= before.first && step < before.end;
    if (!is_kept) place_at(agent, step) = followers.position(agent, static_cast<double>(step) * step_seconds);
  }
}

void Trails::gather(const Followers& followers, std::size_t agent, double seconds) {
  const double begin = std::max(followers.way(agent).first(), seconds - static_cast<double>(seconds_));
  points_.clear();
  const auto add = [&](const glm::vec3& place, double time) {
    points_.push_back({place + glm::vec3(0.0F, above_ground, 0.0F), static_cast<float>(seconds - time)});
  };
  add(followers.position(agent, seconds), seconds);
  for (std::int64_t step = kept_[agent].end - 1; step >= kept_[agent].first; --step) {
    const double time = static_cast<double>(step) * step_seconds;
    if (time <= begin) break;
    add(place_at(agent, step), time);
  }
  add(followers.position(agent, begin), begin);
}

void Trails::draw(SceneLines& lines, const View& view, std::uint32_t color) const {
  glm::vec3 low = points_.front().place, high = low;
  for (const Point& point : points_) low = glm::min(low, point.place), high = glm::max(high, point.place);
  const glm::vec3 middle = 0.5F * (low + high);
  const float radius = 0.5F * glm::distance(low, high);
  const auto is_outside = [&](const glm::vec4& plane) {
    return glm::dot(glm::vec3(plane), middle) + plane.w < -radius;
  };
  if (std::ranges::any_of(view.planes, is_outside)) return;
  const float distance = std::max(glm::distance(view.camera, middle) - radius, nearest_camera);
  const float metres_a_pixel = view.metres_a_pixel * distance, most_off = most_off_px * metres_a_pixel;
  const float pieces = std::clamp(2.0F * radius / (least_piece_px * metres_a_pixel), 1.0F, pieces_of_fading);
  const float longest = seconds_ / pieces;
  for (std::size_t from = 0; from + 1 < points_.size();) {
    Straight straight(on_map(points_[from].place), most_off);
    std::size_t to = from + 1;
    straight.passes(on_map(points_[to].place));
    while (to + 1 < points_.size() && points_[to + 1].age - points_[from].age <= longest &&
           straight.passes(on_map(points_[to + 1].place))) {
      ++to;
    }
    const Point &a = points_[from], &b = points_[to];
    const bool is_jump = glm::distance(a.place, b.place) > fastest_person * (b.age - a.age);
    if (!is_jump) lines.push_back({a.place, b.place, faded(color, 0.5F * (a.age + b.age), seconds_)});
    from = to;
  }
}

void Trails::add(SceneLines& lines, const Stage& stage, const render::Camera& camera, glm::ivec2 picture) {
  const FollowedTracks* const tracks = stage.crowd().tracks();
  if (tracks == nullptr || !make_room(stage)) return;
  const double seconds = tracks->clock().seconds;
  const glm::vec2 size(picture);
  const View view{.planes = render::frustum_planes(render::view_of(camera, size.x / size.y)),
                  .camera = camera.position,
                  .metres_a_pixel = 1.0F / render::pixels_tall(camera, size.y, 1.0F, 1.0F)};
  for (std::size_t agent = 0; agent < tracks->people().count(); ++agent) {
    if (absent_of(stage.crowd())[agent] != 0) continue;
    keep_up(tracks->people(), agent, seconds);
    gather(tracks->people(), agent, seconds);
    const std::uint32_t of_view = debug_color(stage.tuning(), {.measure = stage.posed().measures().of(agent)});
    draw(lines, view, agent == stage.selected() ? selected_color : color_scale(stage.tuning()) ? of_view : plain_color);
  }
}

}  // namespace throng::app
