// The row that picks one of many words: the word, and a list that opens.
#include "app/overlay/widgets.h"

namespace throng::app {
namespace {

constexpr float longest_list = 300;

std::string word_of(int index, std::span<const std::string> words, const char* none) {
  return index < 0 ? none : words[static_cast<std::size_t>(index)];
}

void draw_closed(const Theme& theme, const Area& place, const std::string& word, bool lively) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(place.from, place.to, ImGui::GetColorU32(lively ? colour::well_hovered : colour::well),
                     theme.px(4));
  ImGui::PushClipRect(place.from, {place.to.x - theme.px(18), place.to.y}, true);
  draw_text(theme.small, {place.from.x + theme.px(8), place.from.y + theme.px(4)}, colour::text, word);
  ImGui::PopClipRect();
  const ImVec2 tip(place.to.x - theme.px(10), place.from.y + theme.px(13));
  draw.AddTriangleFilled({tip.x - theme.px(4), tip.y - theme.px(4)}, {tip.x + theme.px(4), tip.y - theme.px(4)}, tip,
                         colour::dim);
}

}  // namespace

bool Widgets::pick(const char* label, int& index, int standard, std::span<const std::string> words, const char* none,
                   const Help& help) {
  const int before = index;
  const std::string standard_word = word_of(standard, words, none);
  const Row row = begin_row(label, index != standard, help, standard_word);
  Area place = row.control;
  place.from.y += theme_.px(1);
  place.to.y -= theme_.px(2);
  if (clickable(label, place)) ImGui::OpenPopup("list");
  draw_closed(theme_, place, word_of(index, words, none), ImGui::IsItemHovered() || ImGui::IsPopupOpen("list"));
  ImGui::SetNextWindowPos({place.from.x, place.to.y});
  ImGui::SetNextWindowSizeConstraints({place.width(), 0}, {place.width(), theme_.px(longest_list)});
  if (ImGui::BeginPopup("list")) {
    for (int i = none == nullptr ? 0 : -1; i < static_cast<int>(words.size()); ++i) {
      const std::string word = word_of(i, words, none);
      ImGui::PushID(i);
      if (ImGui::Selectable(word.c_str(), i == index)) index = i;
      ImGui::PopID();
      record(std::string(label) + ":" + word, {.from = ImGui::GetItemRectMin(), .to = ImGui::GetItemRectMax()});
    }
    ImGui::EndPopup();
  }
  if (row.reset) index = standard;
  end_row(row, label, help, standard_word);
  return index != before;
}

}  // namespace throng::app
