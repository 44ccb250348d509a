#pragma once

#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "app/settings/settings.h"
#include "app/show/camera/camera_bookmarks.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/camera/input.h"
#include "app/show/request/request.h"
#include "app/window/panel/controls/ui_map.h"

namespace throng::app {

class Show;
struct CameraReport;

/// The camera of the person at the window: flown by hand, sent to a place, or left to the show. In a frame:
///     steer(...)  take(...)  show.take(...)  hand_over(...)  show.animate(...)  take_back(...)
class WindowCamera {
 public:
  explicit WindowCamera(const Show& show);

  /// Moves the camera as mouse and keys say, or that of the viewer. A person who takes it in hand has it from then on.
  /// `free` says what the overlay leaves to it.
  void steer(Show& show, const InputFrame& input, const FlyControls& free, float seconds);
  /// Carries out the person's requests.
  void take(const CameraRequest& request, Show& show);
  /// Puts the camera where the person says, even if the scene changes in this frame.
  void put(const CameraPose& place, Show& show);
  /// Says in which part of the window, in pixels from the top left, no panel and no timeline lies. The first call moves
  /// a camera of the show that sees the crowd in the whole picture, so that it sees it there.
  void see_beside(const UiRectangle& area, glm::ivec2 window, Show& show);
  /// Moves the camera until the whole crowd is seen in that part.
  void frame_crowd(Show& show);

  /// Gives the show its camera for this frame. Another scene than before has brought its own. Where a scene is laid out
  /// anew for much larger or smaller characters, the camera goes where all of them are seen.
  void hand_over(Show& show);
  /// Takes the camera as the show has moved it.
  void take_back(const Show& show);

  const render::Camera& camera() const { return fly_.camera(); }
  CameraPose place() const { return fly_.place(); }
  /// Returns the places that the person keeps.
  const CameraBookmarks& bookmarks() const { return bookmarks_; }
  /// Takes other places for the kept ones.
  void take_bookmarks(const CameraBookmarks& bookmarks) { bookmarks_ = bookmarks; }
  /// Adds the values that only this camera knows.
  void report(CameraReport& report) const;

 private:
  void carry_out(const GoHome& asked, Show& show);
  void carry_out(const GoToCamera& asked, Show& show);
  void carry_out(const ToggleFollow& asked, Show& show);
  void carry_out(const FollowBehind& asked, Show& show);
  void carry_out(const SetFlySpeed& asked, Show& /*show*/) { fly_.set_speed(asked.speed); }
  void carry_out(const KeepBookmark& asked, Show& /*show*/) { bookmarks_.at(asked.place) = place(); }
  void carry_out(const GoToBookmark& asked, Show& show);
  void follow_size_of_crowd(Show& show);

  FlyCamera fly_;
  CameraBookmarks bookmarks_;
  Scene scene_;
  double spacing_;                        // CharacterRoles::spacing for which the camera stands right
  bool was_put_ = false;                  // in this frame
  std::optional<std::size_t> begins_at_;  // the camera of the show that it begins at, until see_beside() is called
};

/// Reports what moves the camera of the show.
void report_cameras(const Show& show, CameraReport& report);

}  // namespace throng::app
