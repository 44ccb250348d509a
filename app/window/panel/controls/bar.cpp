#include "app/window/panel/controls/bar.h"

#include "app/settings/option_values.h"

namespace throng::app {

void BarControls::fill(bool chosen) const {
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 ground = chosen ? colour::accent : (hovered ? colour::well_hovered : colour::well);
  ImGui::GetWindowDrawList()->AddRectFilled(last_.from, last_.to, ground, widgets_.theme().px(4));
}

void BarControls::write(const std::string& words, bool chosen) const {
  const float y = last_.from.y + (last_.height() - font_height(widgets_.theme().small)) / 2;
  draw_text(widgets_.theme().small, {middle().x, y}, chosen ? colour::on_accent : colour::text, words, 0.5F);
}

void BarControls::draw_pause() const {
  const Theme& theme = widgets_.theme();
  for (const float side : {-3.5F, 3.5F}) {
    const float x = middle().x + theme.px(side), half = theme.px(1.75F), tall = theme.px(6);
    ImGui::GetWindowDrawList()->AddRectFilled({x - half, middle().y - tall}, {x + half, middle().y + tall},
                                              colour::text);
  }
}

void BarControls::draw_arrow(float way, bool steps) const {
  const Theme& theme = widgets_.theme();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 at = middle();
  const float x = at.x - way * theme.px(steps ? 2 : 0), half = theme.px(5), tall = theme.px(6);
  const ImVec2 tip(x + way * half, at.y), top(x - way * half, at.y - tall), foot(x - way * half, at.y + tall);
  if (way > 0) {
    draw.AddTriangleFilled(top, tip, foot, colour::text);
  } else {
    draw.AddTriangleFilled(tip, top, foot, colour::text);
  }
  if (!steps) return;
  const float bar = at.x + way * theme.px(6);
  draw.AddLine({bar, at.y - tall}, {bar, at.y + tall}, colour::text, theme.px(2));
}

Area BarControls::take(float plain_width, bool from_left) {
  const float width = widgets_.theme().px(plain_width), between = widgets_.theme().px(gap);
  Area taken = place_;
  if (from_left) {
    taken.to.x = taken.from.x + width;
    place_.from.x = taken.to.x + between;
  } else {
    taken.from.x = taken.to.x - width;
    place_.to.x = taken.from.x - between;
  }
  return taken;
}

bool BarControls::show(const std::string& name, const Area& place) {
  last_ = place;
  return widgets_.clickable(name, place);
}

std::string times_words(float times) { return shortest_text(times) + "x"; }

}  // namespace throng::app
