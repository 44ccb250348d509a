#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/settings/settings.h"
#include "app/settings/tuning_pair.h"
#include "app/show/camera/camera_bookmarks.h"
#include "app/show/camera/input.h"
#include "app/show/request/requests.h"

namespace throng::app {

/// The parts of the overlay that keys open and close.
struct OverlaySwitches {
  bool hidden = false;
  bool help = false;
  bool log = false;            ///< of messages
  std::string search = {};     ///< among the values of all tabs; empty: a tab is shown
  bool enters_search = false;  ///< the cursor is wanted in its field
  int tabs_further = 0;        ///< to the right; negative: to the left
  int steps_larger = 0;        ///< how much larger the panel is; negative: smaller
  bool opens_file = false;     ///< a file is to be chosen
  bool saves = false;          ///< the crowd is to be saved
  bool saves_anew = false;     ///< under a name that is to be chosen
};

/// Says which parts are open while keys are pressed. Esc closes them from the top down: a list, a search, the help, the
/// log of messages, the viewer of one character, the card of the selected agent.
struct OpenThings {
  bool list = false;
  bool typing = false;                         ///< a text field has the keys
  std::optional<std::uint32_t> selected = {};  ///< the selected agent
  glm::vec3 ahead{0.0F};                       ///< where the camera looks
  std::optional<ViewerSettings> viewer = {};   ///< of the viewer that is open
  bool has_moments = false;                    ///< a replay or a recorded crowd, whose moments arrows go through
  std::array<bool, bookmark_count> kept = {};  ///< [bookmark]: the person keeps a place there
};

/// Carries out F11 and the combinations with Ctrl or Alt that were pressed in this frame (README.md has the table).
/// While a text field has the keys, these are the ones that no text field knows.
void apply_combinations(const InputFrame& input, const OpenThings& open, OverlaySwitches& switches, Requests& requests);

/// Carries out the keys pressed in this frame that are no part of a combination. The caller leaves it out while a text
/// field has the keys.
void apply_hotkeys(const InputFrame& input, const OpenThings& open, OverlaySwitches& switches, Tuning& tuning,
                   Requests& requests);

/// Brings the other of two tunings into use by B, or says how to get one.
void apply_pair_key(const InputFrame& input, TuningPair& pair, Tuning& tuning, Requests& requests);

/// Tells a click at the crowd from a drag, and from a click at the overlay.
class CrowdClick {
 public:
  /// Returns the place of a press whose button is let go in this frame. `pointer_free` says that the overlay does not
  /// use the pointer. Call it once a frame.
  std::optional<PicturePoint> update(const InputFrame& input, bool pointer_free);

 private:
  bool was_down_ = false;
  std::optional<PicturePoint> pressed_at_;  // at the crowd, while the pointer stays there
};

}  // namespace throng::app
