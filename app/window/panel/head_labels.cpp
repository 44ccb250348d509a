#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "app/show/camera/fly_camera.h"
#include "app/window/panel/cards.h"
#include "app/window/panel/picture_aids.h"

namespace throng::app {
namespace {

constexpr float nearer_to_take_over = 1.25F;  // than one that was shown, before another takes its place
constexpr int most_lines_up = 1, most_lines_of_selected = 30;

/// A figure that wants a place.
struct HeadLabel {
  const HeadFigures* head = nullptr;
  ImVec2 at;            // just above the head
  float priority = 0;   // the greatest is placed first
  int kept_lines = -1;  // where it was in the frame before; -1: it was not shown
  bool is_selected = false;
};

/// The labels that have a place, in rows as high as one, so that each is compared with few others.
class PlacedLabels {
 public:
  PlacedLabels(const Area& crowd, std::span<const Area> taken, float height, std::size_t most)
      : crowd_(crowd), taken_(taken), height_(height) {
    first_in_row_.assign(static_cast<std::size_t>(std::max(crowd.height() / height, 0.0F)) + 3, no_label);
    labels_.reserve(most);
  }

  [[nodiscard]] bool has_room_for(const Area& place) const {
    const bool inside = place.from.x >= crowd_.from.x && place.to.x <= crowd_.to.x && place.from.y >= crowd_.from.y &&
                        place.to.y <= crowd_.to.y;
    if (!inside || !is_free(place, taken_)) return false;
    const std::size_t row = row_of(place);
    for (std::size_t near = row - 1; near <= row + 1; ++near) {
      for (std::size_t i = first_in_row_[near]; i != no_label; i = labels_[i].next) {
        if (overlap(labels_[i].place, place)) return false;
      }
    }
    return true;
  }

  void add(const Area& place) {
    std::size_t& first = first_in_row_[row_of(place)];
    labels_.push_back({place, first});
    first = labels_.size() - 1;
  }

 private:
  static constexpr std::size_t no_label = SIZE_MAX;
  struct Label {
    Area place;
    std::size_t next;  // in the same row
  };
  std::size_t row_of(const Area& place) const {
    return 1 + static_cast<std::size_t>(std::max((place.from.y - crowd_.from.y) / height_, 0.0F));
  }

  Area crowd_;
  std::span<const Area> taken_;
  float height_;
  std::vector<std::size_t> first_in_row_;
  std::vector<Label> labels_;
};

std::string words_above(const HeadFigures& head) {
  if (head.interval == 0) return head.id;
  std::string words = head.id.empty() ? "" : head.id + ": ";
  words += std::to_string(head.interval);
  return head.bone_level == 0 ? words : words + " L" + std::to_string(head.bone_level);
}

int lines_in_frame_before(const AidsMemory& memory, std::uint32_t agent) {
  const auto kept = std::ranges::lower_bound(memory.heads, agent, {}, &KeptHead::agent);
  return kept != memory.heads.end() && kept->agent == agent ? kept->lines_up : -1;
}

/// Returns the figures of heads in front of the camera, in the order in which they get a place.
std::vector<HeadLabel> wanted_labels(const FrameReport& report, const AidsMemory& memory, ImVec2 size) {
  const render::CameraView view = render::view_of(camera_at(report.camera), size.x / size.y);
  const glm::mat4 view_projection = view.projection * view.view;
  std::vector<HeadLabel> labels;
  labels.reserve(report.heads.size());
  for (const HeadFigures& head : report.heads) {
    const glm::vec4 clip = view_projection * glm::vec4(head.x, head.y, head.z, 1.0F);
    if (clip.w <= render::Camera::near_distance) continue;
    HeadLabel label{.head = &head, .at = {}};
    label.at = ImVec2((clip.x / clip.w * 0.5F + 0.5F) * size.x, (0.5F - clip.y / clip.w * 0.5F) * size.y);
    label.kept_lines = lines_in_frame_before(memory, head.agent);
    label.is_selected = report.selected && report.selected->agent == head.agent;
    label.priority = (label.kept_lines >= 0 ? nearer_to_take_over : 1.0F) / clip.w;
    if (label.is_selected) label.priority = std::numeric_limits<float>::infinity();
    labels.push_back(label);
  }
  std::ranges::stable_sort(labels, std::ranges::greater(), &HeadLabel::priority);
  return labels;
}

/// The measures of a label, and where it may stand.
struct LabelShape {
  const Theme& theme;
  ImVec2 at;
  float width;

  [[nodiscard]] float line() const { return font_height(theme.small) + theme.px(4); }
  [[nodiscard]] Area place(int lines_up, float margin = 0) const {
    const float bottom = at.y + theme.px(1) - static_cast<float>(lines_up) * line();
    return {.from = {at.x - width / 2 - theme.px(4) - margin, bottom - font_height(theme.small) - theme.px(2) - margin},
            .to = {at.x + width / 2 + theme.px(4) + margin, bottom + margin}};
  }
};

/// Returns how many lines up the label has room; nothing where it has none. One that stood a line up comes down only
/// where there is plenty of room, so that it does not go to and fro.
std::optional<int> lines_with_room(const PlacedLabels& placed, const LabelShape& shape, const HeadLabel& label) {
  const bool fits = placed.has_room_for(shape.place(0));
  if (fits && (label.kept_lines <= 0 || placed.has_room_for(shape.place(0, shape.theme.px(4))))) return 0;
  const int most = label.is_selected ? most_lines_of_selected : most_lines_up;
  for (int lines = 1; lines <= most; ++lines) {
    if (placed.has_room_for(shape.place(lines))) return lines;
    if (label.is_selected && placed.has_room_for(shape.place(-lines))) return -lines;
  }
  return fits ? std::optional(0) : std::nullopt;
}

void draw_leader(const LabelShape& shape, int lines_up) {
  const ImVec2 top(shape.at.x, shape.place(lines_up).to.y);
  ImGui::GetWindowDrawList()->AddLine(shape.at, top, colour::dim, shape.theme.px(1));
}

void draw_label(const Theme& theme, const Area& place, const HeadFigures& head, const std::string& words) {
  ImGui::GetWindowDrawList()->AddRectFilled(place.from, place.to, colour::panel, theme.px(3));
  if (head.interval > 0) {
    ImGui::GetWindowDrawList()->AddRectFilled(place.from, {place.from.x + theme.px(3), place.to.y},
                                              colour::interval(head.interval), theme.px(3),
                                              ImDrawFlags_RoundCornersLeft);
  }
  draw_text(theme.small, {place.from.x + theme.px(5), place.from.y + theme.px(1)}, colour::text, words);
}

/// A label that has its place.
struct DrawnLabel {
  const HeadFigures* head;
  Area place;
};

}  // namespace

void show_head_labels(const TabContext& context, const Area& crowd, std::span<const Area> taken, AidsMemory& memory) {
  const FrameReport& report = context.report;
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  if (report.heads.empty()) {
    memory.heads.clear();
    return;
  }
  const std::vector<HeadLabel> labels = wanted_labels(report, memory, ImGui::GetIO().DisplaySize);
  PlacedLabels placed(crowd, taken, font_height(theme.small) + theme.px(2), labels.size());
  std::vector<DrawnLabel> drawn;
  drawn.reserve(labels.size());
  memory.heads.clear();
  begin_clear_window("Heads", crowd);
  widgets.record("Heads", crowd);
  for (const HeadLabel& label : labels) {
    const LabelShape shape{theme, label.at, text_width(theme.small, words_above(*label.head))};
    const std::optional<int> lines = lines_with_room(placed, shape, label);
    if (!lines) continue;
    placed.add(shape.place(*lines));
    if (*lines > 0) draw_leader(shape, *lines);
    drawn.push_back({label.head, shape.place(*lines)});
    memory.heads.push_back({label.head->agent, *lines});
  }
  for (const auto& [head, place] : drawn) {  // over the leaders
    draw_label(theme, place, *head, words_above(*head));
    widgets.record("head:" + std::to_string(head->agent), place);
  }
  ImGui::End();
  std::ranges::sort(memory.heads, {}, &KeptHead::agent);
}

}  // namespace throng::app
