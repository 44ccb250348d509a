#include "app/window/window_camera.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "app/people/crowd/crowd.h"
#include "app/show/crowd_framing.h"
#include "app/show/report/frame_report.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "app/show/viewer/viewer.h"

namespace throng::app {
namespace {

// The middle of the selected agent, or of the crowd.
glm::vec3 middle_of_interest(const Stage& stage) {
  const std::optional<std::uint32_t> agent = stage.selected();
  if (!agent) return middle_of(stage.crowd());
  const UprightBody body = body_of(stage, *agent);
  return body.foot + glm::vec3(0.0F, 0.5F * body.height, 0.0F);
}

double spacing_of(const Show& show) { return show.stage().crowd().laid_out_for().spacing(); }

bool differ_much(double spacing, double other) {
  constexpr double much = 1.15;  // a camera that stands right for one is a little near or far for the other
  return spacing > much * other || other > much * spacing;
}

constexpr float looks_down = -0.35F;  // radians, so that people behind others are seen

PicturePart part_of(const UiRectangle& area, glm::ivec2 window) {
  const auto across = static_cast<float>(window.x), along = static_cast<float>(window.y);
  return {.left = area.x / across,
          .top = area.y / along,
          .right = (area.x + area.width) / across,
          .bottom = (area.y + area.height) / along};
}

}  // namespace

WindowCamera::WindowCamera(const Show& show)
    : fly_(place_of(show.view().camera)), scene_(show.stage().tuning().scene), spacing_(spacing_of(show)) {
  const std::vector<NamedCamera> cameras = cameras_of(show.stage(), show.view().aspect());
  const auto is_shown = [&](const NamedCamera& named) { return camera_at(named.place) == show.view().camera; };
  const auto shown = std::ranges::find_if(cameras, is_shown);
  if (shown != cameras.end()) begins_at_ = static_cast<std::size_t>(shown - cameras.begin());
}

void WindowCamera::see_beside(const UiRectangle& area, glm::ivec2 window, Show& show) {
  ShowView& view = show.view();
  view.free = part_of(area, window);
  const auto named = std::exchange(begins_at_, std::nullopt);
  if (!named) return;
  view.camera = camera_at(cameras_of(show.stage(), view.aspect(), view.free).at(*named).place);
  fly_.set_camera(view.camera);
}

void WindowCamera::steer(Show& show, const InputFrame& input, const FlyControls& free, float seconds) {
  if (Viewer* const viewer = show.viewer()) return viewer->turntable().update(input, free);
  const render::Camera before = fly_.camera();
  FlyControls controls = free;
  if (orbits(input)) controls.orbit_about = middle_of_interest(show.stage());
  fly_.update(input, controls, seconds);
  if (fly_.camera() != before) show.view().films = false;
}

void WindowCamera::take_back(const Show& show) { fly_.set_camera(show.view().camera); }

void WindowCamera::take(const CameraRequest& request, Show& show) {
  std::visit([&](const auto& asked) { carry_out(asked, show); }, request);
}

void WindowCamera::carry_out(const GoHome& /*asked*/, Show& show) {
  show.view().guide.follow(false);
  const ShowView& view = show.view();
  put(place_of(view.guide.home(show.stage(), view.aspect(), view.free)), show);
  show.view().films = true;
}

void WindowCamera::carry_out(const GoToCamera& asked, Show& show) {
  const std::vector<NamedCamera> cameras = cameras_of(show.stage(), show.view().aspect(), show.view().free);
  if (asked.camera < cameras.size()) put(cameras[asked.camera].place, show);
}

void WindowCamera::carry_out(const ToggleFollow& /*asked*/, Show& show) {
  show.view().guide.follow(!show.view().guide.follows());
  show.view().films = false;
}

void WindowCamera::carry_out(const FollowBehind& /*asked*/, Show& show) {
  if (!show.stage().selected()) return;
  show.view().guide.follow_behind(FollowCamera(*show.stage().selected()), true);
  show.view().films = false;
}

void WindowCamera::carry_out(const GoToBookmark& asked, Show& show) {
  if (const auto& kept = bookmarks_.at(asked.place)) put(*kept, show);
}

void WindowCamera::put(const CameraPose& place, Show& show) {
  begins_at_.reset();
  fly_.set_camera(camera_at(place));
  show.view().films = false;
  was_put_ = true;
}

void WindowCamera::frame_crowd(Show& show) {
  const std::vector<FramedBox> boxes = boxes_of(show.stage());
  if (boxes.empty()) return;
  fly_.set_camera(framed(fly_.camera(), boxes, show.view().aspect(), show.view().free));
  show.view().films = false;
}

void WindowCamera::hand_over(Show& show) {
  const bool is_another_scene = show.stage().tuning().scene != scene_;
  scene_ = show.stage().tuning().scene;
  if (is_another_scene && !was_put_) fly_.set_camera(show.view().camera);
  if (is_another_scene && was_put_) show.view().films = false;
  if (is_another_scene || was_put_) spacing_ = spacing_of(show);
  follow_size_of_crowd(show);
  was_put_ = false;
  show.view().camera = fly_.camera();
}

// People of a recorded crowd stay where they are, whatever their size.
void WindowCamera::follow_size_of_crowd(Show& show) {
  if (!differ_much(spacing_of(show), spacing_)) return;
  spacing_ = spacing_of(show);
  const ShowView& view = show.view();
  const Stage& stage = show.stage();
  const bool moves_by_itself = view.guide.follows() || (view.films && view.guide.can_film(stage));
  if (moves_by_itself || stage.crowd().tracks() != nullptr) return;
  render::Camera camera = view.guide.home(stage, view.aspect(), view.free);
  camera.pitch = std::min(camera.pitch, looks_down);
  fly_.set_camera(camera);
  frame_crowd(show);
}

void WindowCamera::report(CameraReport& report) const {
  report.fly_speed = fly_.speed();
  for (std::size_t i = 0; i < bookmark_count; ++i) report.kept.at(i) = bookmarks_.at(i).has_value();
}

void report_cameras(const Show& show, CameraReport& report) {
  report.can_film = show.view().guide.can_film(show.stage());
  report.films = show.view().films && report.can_film;
  report.follows = show.view().guide.follows();
}

}  // namespace throng::app
