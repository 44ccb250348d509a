#include "app/overlay/hotkeys.h"

namespace throng::app {

void apply_hotkeys(const InputFrame& input, bool anybody_selected, OverlaySwitches& switches, Tuning& tuning,
                   OverlayCommands& commands) {
  commands.exact_crowd = input.down(Key::x);
  for (const Key key : input.pressed) {
    switch (key) {
      case Key::space:
        tuning.paused = !tuning.paused;
        break;
      case Key::tab:
        switches.hidden = !switches.hidden;
        break;
      case Key::f1:
        switches.help = !switches.help;
        break;
      case Key::f:
        commands.frame_crowd = true;
        break;
      case Key::c:
        commands.copy_camera = true;
        break;
      case Key::r:
        commands.record = true;
        break;
      case Key::f5:
        commands.reload_shaders = true;
        break;
      case Key::f12:
        commands.screenshot = true;
        break;
      case Key::p:
        commands.push_over = anybody_selected;
        break;
      case Key::escape:
        (anybody_selected ? commands.deselect : commands.quit) = true;
        break;
      default:
        break;
    }
  }
}

}  // namespace throng::app
