#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/show/camera/input.h"
#include "app/window/panel/dialog.h"

namespace throng::app {

/// Lets a person choose a file to open, or a name to save under: a list of the folders and files that can be opened,
/// files of before on top, and a field for a name or a path. Letters filter the list; up, down and Enter walk in it;
/// Backspace in an empty field goes to the folder above; Esc closes it. The list follows a path that is typed.
class FilePicker {
 public:
  enum class Purpose : std::uint8_t { open, save };
  using Test = std::function<bool(const std::filesystem::path&)>;

  /// `is_openable` says which files are listed to be opened. To be saved over, those with `ending` are; a name without
  /// it gets it.
  FilePicker(Test is_openable, std::string ending) : is_openable_(std::move(is_openable)), ending_(std::move(ending)) {}

  /// Opens it in the folder where it was last; at first in the working folder.
  void open(Purpose purpose);
  [[nodiscard]] bool is_open() const { return purpose_.has_value(); }
  /// Returns what the person chooses for; is_open() holds.
  [[nodiscard]] Purpose purpose() const { return *purpose_; }

  /// Shows it, and takes the keys pressed in this frame. `recent` are files of before, the newest first. Returns the
  /// chosen file once, and closes then.
  std::optional<std::string> show(Widgets& widgets, const InputFrame& input, std::span<const std::string> recent);

 private:
  struct Row {
    std::string name, words;
    std::string where = {};  ///< the folder of a file of before
    bool is_folder = false;
  };

  void go_to(const std::filesystem::path& folder);
  void list_folder(const std::filesystem::path& folder);
  void set_field(std::string text);
  void list_rows(std::span<const std::string> recent);
  void walk(const InputFrame& input);
  std::optional<std::string> take_row(std::size_t row);
  std::optional<std::string> take_field();
  std::optional<std::string> take(const std::filesystem::path& file);
  std::optional<std::string> show_rows(Widgets& widgets, const Area& place);
  void draw_row(const Theme& theme, const Area& line, const Row& row) const;
  [[nodiscard]] std::string words_at_foot() const;
  std::optional<std::string> show_foot(Widgets& widgets, const Area& place);
  void show_field(Widgets& widgets, const Area& place);

  Test is_openable_;
  std::string ending_;
  std::optional<Purpose> purpose_;
  std::filesystem::path folder_ = ".";  // that a name in the field is relative to
  std::filesystem::path listed_;        // that of the list: a path in the field leads to another
  std::vector<Row> in_folder_, rows_;   // all files of the listed folder, and the files that the list shows
  std::string field_;
  std::string complaint_;                      // why the field names no file to take; empty: it does
  std::optional<std::filesystem::path> over_;  // the file that is replaced when it is asked for once more
  std::optional<std::size_t> marked_;          // the row that keys have come to
  int texts_ = 0;                              // ImGui keeps the text of a field by its number
  bool scrolls_ = false;
};

}  // namespace throng::app
