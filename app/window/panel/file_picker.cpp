#include "app/window/panel/file_picker.h"

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

#include "engine/base/files/folder_entries.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_path = 1023, most_recent_rows = 5;
constexpr float picker_row = 24, picker_button = 84;
constexpr const char* above = "..";

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return text;
}

bool has_letters(const std::string& name, const std::string& letters) {
  return in_small_letters(name).find(in_small_letters(letters)) != std::string::npos;
}

bool is_folder_there(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// Without a slash at its end, behind which its parent would be itself.
fs::path tidied(const fs::path& folder) {
  const fs::path normal = folder.lexically_normal();
  return normal.has_filename() || !normal.has_relative_path() ? normal : normal.parent_path();
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

}  // namespace

void FilePicker::open(Purpose purpose) {
  purpose_ = purpose;
  std::error_code ignored;
  if (!is_folder_there(folder_)) folder_ = ".";
  go_to(fs::absolute(folder_, ignored));
}

void FilePicker::go_to(const fs::path& folder) {
  set_field("");
  const auto entries = folder_entries(folder);
  if (!entries) return static_cast<void>(complaint_ = entries.error().message);
  folder_ = tidied(folder);
  list_folder(folder_);
}

// A folder that cannot be read has an empty list.
void FilePicker::list_folder(const fs::path& folder) {
  listed_ = folder;
  in_folder_.clear();
  if (folder.has_relative_path()) in_folder_.push_back({.name = above, .words = above, .is_folder = true});
  const auto entries = folder_entries(folder);
  if (!entries) return;
  for (const FolderEntry& entry : *entries) {
    const fs::path file = folder / entry.name;
    const bool fits = *purpose_ == Purpose::open ? is_openable_(file) : file.extension() == ending_;
    if (!entry.is_folder && !fits) continue;
    in_folder_.push_back({.name = entry.name, .words = plain_text(entry.name), .is_folder = entry.is_folder});
  }
}

void FilePicker::set_field(std::string text) {
  if (text != field_) ++texts_;  // a field whose text stays keeps the keys
  field_ = std::move(text);
  marked_.reset();
  over_.reset();
  complaint_.clear();
}

void FilePicker::list_rows(std::span<const std::string> recent) {
  rows_.clear();
  if (*purpose_ == Purpose::open) {
    for (const std::string& file : recent.first(std::min(recent.size(), most_recent_rows))) {
      if (!has_letters(file, field_)) continue;
      const fs::path path(file);
      rows_.push_back({.name = file,
                       .words = plain_text(path.filename().string()),
                       .where = plain_text(path.parent_path().string())});
    }
  }
  const fs::path typed(field_), folder = tidied(folder_ / typed.parent_path());
  if (folder != listed_ && is_folder_there(folder)) list_folder(folder);
  const std::string letters = *purpose_ == Purpose::open ? typed.filename().string() : std::string();
  for (const Row& row : in_folder_) {
    if (has_letters(row.name, letters)) rows_.push_back(row);
  }
  if (marked_ && *marked_ >= rows_.size()) marked_.reset();
}

void FilePicker::walk(const InputFrame& input) {
  constexpr std::size_t page = 10;
  if (rows_.empty()) return;
  const std::size_t last = rows_.size() - 1;
  for (const Key key : input.pressed) {
    if (key == Key::down) marked_ = marked_ ? std::min(*marked_ + 1, last) : 0;
    if (key == Key::page_down) marked_ = std::min(marked_.value_or(0) + page, last);
    if (key == Key::up) marked_ = marked_.value_or(0) - std::min<std::size_t>(marked_.value_or(0), 1);
    if (key == Key::page_up) marked_ = marked_.value_or(0) - std::min(marked_.value_or(0), page);
    scrolls_ |= key == Key::down || key == Key::up || key == Key::page_down || key == Key::page_up;
  }
}

std::optional<std::string> FilePicker::take_row(std::size_t row) {
  const Row taken = rows_[row];
  const fs::path path = taken.name == above ? listed_.parent_path() : listed_ / taken.name;
  if (taken.is_folder) return go_to(path), std::nullopt;
  if (*purpose_ == Purpose::open) return take(path);
  set_field(listed_ == folder_ ? taken.name : path.string());  // which is replaced when it is saved
  return std::nullopt;
}

std::optional<std::string> FilePicker::take_field() {
  if (field_.empty()) return std::nullopt;
  const fs::path path = (folder_ / field_).lexically_normal();
  if (is_folder_there(path)) return go_to(path), std::nullopt;
  const bool is_filter = *purpose_ == Purpose::open && !is_there(path) && !rows_.empty();
  return is_filter ? take_row(0) : take(path);
}

std::optional<std::string> FilePicker::take(const fs::path& file) {
  if (*purpose_ == Purpose::open && !is_there(file)) {
    complaint_ = plain_text(file.string()) + ": there is no such file";
    return std::nullopt;
  }
  fs::path named = file;
  if (*purpose_ == Purpose::save) {
    if (named.extension() != ending_) named += ending_;
    if (is_there(named) && over_ != named) return over_ = named, std::nullopt;
  }
  purpose_.reset();
  return named.string();
}

std::optional<std::string> FilePicker::show(Widgets& widgets, const InputFrame& input,
                                            std::span<const std::string> recent) {
  const Theme& theme = widgets.theme();
  const Dialog dialog(widgets, *purpose_ == Purpose::open ? "Open a file" : "Save the crowd", {600, 460});
  const Area all = dialog.content();
  const bool goes_up = field_.empty() && input.was_pressed(Key::backspace) && folder_.has_relative_path();
  if (goes_up) go_to(folder_.parent_path());
  draw_text(theme.small, all.from, colour::dim, plain_text(listed_.string()));
  show_field(widgets, {.from = {all.from.x, all.from.y + theme.px(22)}, .to = {all.to.x, all.from.y + theme.px(46)}});
  list_rows(recent);
  walk(input);
  const bool enters = input.was_pressed(Key::enter) || input.was_pressed(Key::keypad_enter);
  std::optional<std::string> chosen;
  if (enters) chosen = marked_ ? take_row(*marked_) : take_field();
  if (!chosen && is_open()) {
    if (enters) list_rows(recent);
    chosen = show_rows(widgets, {.from = {all.from.x, all.from.y + theme.px(54)},
                                 .to = {all.to.x, dialog.foot().from.y - theme.px(10)}});
  }
  if (!chosen && is_open()) chosen = show_foot(widgets, dialog.foot());
  if (input.was_pressed(Key::escape)) purpose_.reset();
  return chosen;
}

void FilePicker::show_field(Widgets& widgets, const Area& place) {
  ImGui::PushID(texts_);
  if (!ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) imgui::focus_next_item();
  const char* const hint = *purpose_ == Purpose::open ? "letters of a name, or a path" : "a name, or a path";
  if (widgets.text_field("picker:field", field_, hint, place, longest_path)) {
    marked_.reset();
    over_.reset();
    complaint_.clear();
  }
  ImGui::PopID();
}

std::optional<std::string> FilePicker::show_rows(Widgets& widgets, const Area& place) {
  const Theme& theme = widgets.theme();
  std::optional<std::size_t> clicked;
  ImGui::SetCursorScreenPos(place.from);
  ImGui::BeginChild("files", {place.width(), place.height()}, false, 0);
  const float width = ImGui::GetContentRegionAvail().x;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    ImGui::PushID(static_cast<int>(i));
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const Area line{.from = from, .to = {from.x + width, from.y + theme.px(picker_row)}};
    if (widgets.pressable("picker:" + row.name, line)) clicked = i;
    const bool begins_folder = i > 0 && !rows_[i - 1].where.empty() && row.where.empty();
    if (begins_folder) ImGui::GetWindowDrawList()->AddLine(from, {line.to.x, from.y}, colour::grid);
    const ImU32 ground = marked_ == i ? colour::accent_soft : (ImGui::IsItemHovered() ? colour::well_hovered : 0);
    ImGui::GetWindowDrawList()->AddRectFilled(line.from, line.to, ground, theme.px(4));
    draw_row(theme, line, row);
    if (scrolls_ && marked_ == i) ImGui::SetScrollHereY();
    ImGui::SetCursorScreenPos({from.x, line.to.y});
    ImGui::PopID();
  }
  ImGui::Dummy({1, 1});
  scrolls_ = false;
  ImGui::EndChild();
  return clicked ? take_row(*clicked) : std::nullopt;
}

void FilePicker::draw_row(const Theme& theme, const Area& line, const Row& row) const {
  const float left = line.from.x + theme.px(8), y = line.from.y + theme.px(4), room = line.to.x - left;
  const std::string words = fitted(theme.regular, room, row.words + (row.is_folder ? "/" : ""));
  draw_text(theme.regular, {left, y}, colour::text, words);
  if (row.where.empty()) return;
  const float begin = text_width(theme.regular, words) + theme.px(10);
  draw_text(theme.small, {left + begin, y + theme.px(1)}, colour::dim, fitted(theme.small, room - begin, row.where));
}

std::string FilePicker::words_at_foot() const {
  if (over_) return plain_text(over_->filename().string()) + " is there; Enter replaces it";
  if (!complaint_.empty()) return complaint_;
  const bool has_files = std::ranges::any_of(rows_, [](const Row& row) { return !row.is_folder; });
  if (has_files) return "Up, Down and Enter walk; Backspace: the folder above";
  return *purpose_ == Purpose::open ? "No file of this folder is a model, a recorded or a kept crowd"
                                    : "No crowd is kept in this folder";
}

std::optional<std::string> FilePicker::show_foot(Widgets& widgets, const Area& place) {
  const Theme& theme = widgets.theme();
  const float width = theme.px(picker_button);
  const std::string words = words_at_foot();
  const float room = place.width() - 2 * width - theme.px(16);
  const bool is_one_line = text_width(theme.small, words) <= room;
  draw_wrapped(theme.small, {place.from.x, place.from.y + theme.px(is_one_line ? 6 : -1)},
               over_ || !complaint_.empty() ? colour::changed : colour::dim, room, words);
  ImGui::SetCursorScreenPos({place.to.x - 2 * width - theme.px(8), place.from.y});
  if (widgets.named_button("Cancel", "picker:cancel", {.what = "Esc"}, width)) purpose_.reset();
  if (!is_open()) return std::nullopt;
  ImGui::SetCursorScreenPos({place.to.x - width, place.from.y});
  const char* const does = *purpose_ == Purpose::open ? "Open" : (over_ ? "Replace" : "Save");
  if (!widgets.named_button(does, "picker:take", {.what = "Enter"}, width)) return std::nullopt;
  return marked_ ? take_row(*marked_) : take_field();
}

}  // namespace throng::app
