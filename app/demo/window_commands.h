#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/demo/dropped_tracks.h"
#include "app/demo/window_session.h"
#include "app/overlay/overlay.h"
#include "app/recording/crowd_file.h"
#include "app/settings/preset.h"

namespace throng::app {

/// Does what a person asks for in the overlay, and says what came of it.
class WindowCommands {
 public:
  WindowCommands(WindowSession& session, Overlay& overlay) : session_(session), overlay_(overlay) {}

  /// Does all but what is done to values and to the picture.
  void obey(const OverlayCommands& commands);
  /// Does what is asked of the picture, once it is drawn.
  void obey_after_drawing(const OverlayCommands& commands);

  /// Takes what a crowd file keeps for a window alone: what is compared, and the bookmarks of the camera.
  void take_kept(const CrowdSetup& setup);

  /// Begins to record into an unused file, or ends the recording.
  void toggle_recording();

 private:
  void obey_hands(const OverlayCommands& commands);
  void obey_sweep(const OverlayCommands& commands);
  void obey_presets(const OverlayCommands& commands);
  void obey_body(const OverlayCommands& commands, std::size_t character);
  void obey_bone_lod(const OverlayCommands& commands, std::size_t character);
  void obey_crowd_files(const OverlayCommands& commands);
  void save_crowd(const std::filesystem::path& file);
  void open_crowd(const std::filesystem::path& file);
  void take(const Preset& preset);
  void load_into_other(const std::string& name);
  void load_preset(const std::filesystem::path& file);
  void replace_models(const std::vector<std::string>& files);
  void copy_command_line();
  void copy(const std::string& options);
  void say_where(const anim::Result<std::filesystem::path>& written);
  void take_screenshot();
  Messages& messages() { return session_.messages(); }

  WindowSession& session_;
  Overlay& overlay_;
  DroppedTracks tracks_;
  int screenshots_ = 0;
  int recordings_ = 0;
};

}  // namespace throng::app
