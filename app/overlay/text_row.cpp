// The row that edits a few words.
#include <algorithm>

#include "app/overlay/widgets.h"

namespace throng::app {

bool Widgets::text(const char* label, std::string& value, const char* hint, const Help& help) {
  const Row row = begin_row(label, false, help, "");
  std::array<char, 64> typed = {};
  value.copy(typed.data(), typed.size() - 1);
  const Area field{.from = {row.control.from.x, row.control.from.y + theme_.px(1)}, .to = row.control.to};
  ImGui::SetCursorScreenPos(field.from);
  ImGui::SetNextItemWidth(field.width());
  const bool changed = ImGui::InputTextWithHint("##text", hint, typed.data(), typed.size());
  record(std::string(label) + ".field", field);
  if (changed) value = typed.data();
  end_row(row, label, help, "");
  return changed;
}

}  // namespace throng::app
