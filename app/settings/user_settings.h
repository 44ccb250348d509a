#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/settings/output_choices.h"
#include "app/settings/settings.h"
#include "engine/base/result.h"

namespace throng::app {

/// What a person leaves set at a window for its next start.
struct UserSettings {
  std::string quality;                    ///< as `--quality` takes it; empty: what the device decides
  int width = 0, height = 0;              ///< of the window, pixels; 0: as usual
  int panel_width = 0;                    ///< pixels of a plain screen; 0: as usual
  std::vector<std::string> recent_files;  ///< whole paths, the newest first
  OutputChoices output = {};

  friend bool operator==(const UserSettings&, const UserSettings&) = default;
};

/// Returns the file of the settings in configuration_folder(); empty if the system names no folder.
std::filesystem::path user_settings_file();

/// Reads settings. A file that is not there has none. Errors: the file is damaged.
Result<UserSettings> read_user_settings(const std::filesystem::path& file);
/// Writes the file whole or not at all, and makes its folder.
Status write_user_settings(const std::filesystem::path& file, const UserSettings& settings);

/// Starts a window with settings where its options say nothing else.
void take_user_settings(const UserSettings& settings, DemoOptions& options);

}  // namespace throng::app
