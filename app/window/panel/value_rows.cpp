// The rows of the values in the table of values.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/window/panel/tabs.h"

namespace throng::app {

bool TabContext::row(const char* key, const NumberScale& scale, const Help& help) const {
  bool changed = false;
  unless_idle(key, [&] { changed = edit(tuning_value(key), scale, help); });
  return changed;
}

bool TabContext::edit(const TuningValue& row, const NumberScale& scale, const Help& help) const {
  const char* const label = row.label;
  const std::string now = row.text(tuning), before = row.text(standard);
  std::string text;
  if (row.form == TuningValue::Form::on_off) {
    bool on = now == "on";
    if (!widgets.toggle(label, on, before == "on", help)) return false;
    text = on ? "on" : "off";
  } else if (row.form == TuningValue::Form::word) {
    const auto index_of = [&](const std::string& word) {
      return static_cast<int>(std::ranges::find(row.words, word) - row.words.begin());
    };
    int index = index_of(now);
    std::vector<const char*> why_not;
    for (const char* const word : row.words) {
      why_not.push_back(why_not_choose(row.key, word, tuning, report.situation));
    }
    if (!widgets.choose(label, index, index_of(before), row.words, help, why_not)) return false;
    text = row.words[static_cast<std::size_t>(index)];
  } else {
    double number = std::strtod(now.c_str(), nullptr);
    const double usual = std::strtod(before.c_str(), nullptr);
    if (!widgets.number(label, number, usual, scale, help)) return false;
    text = number == usual ? before : fixed(number, scale.decimals);
  }
  row.read(tuning, text);
  return true;
}

}  // namespace throng::app
