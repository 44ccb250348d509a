#include "app/settings/tuning_values.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "app/settings/tuning_value_table.h"

namespace throng::app {
namespace {

void replace(std::string& text, std::string_view what, const std::string& by) {
  const std::size_t place = text.find(what);
  if (place != std::string::npos) text.replace(place, what.size(), by);
}

}  // namespace

std::span<const TuningValue> tuning_values() {
  static const std::vector<TuningValue> values = tuning_value_table();
  return values;
}

const TuningValue* find_tuning_value(std::string_view key) {
  const auto found = std::ranges::find(tuning_values(), key, &TuningValue::key);
  return found == tuning_values().end() ? nullptr : &*found;
}

std::string TuningValue::name() const {
  std::string words = *label != '\0' ? label : std::string(key);
  if (*label == '\0') std::ranges::replace(words, '_', ' ');
  return words;
}

const TuningValue& tuning_value(std::string_view key_or_option) {
  const auto found = std::ranges::find_if(tuning_values(), [&](const TuningValue& value) {
    return value.key == key_or_option || value.option_name() == key_or_option;
  });
  assert(found != tuning_values().end());
  return *found;
}

std::string description(const TuningValue& value) {
  std::string text(value.help);
  const std::string standard = value.text(Tuning());
  replace(text, "{values}", value.values);
  replace(text, "{default}", standard == "0" && !value.zero.empty() ? std::string(value.zero) : standard);
  return text;
}

void copy_value(const TuningValue& value, const Tuning& from, Tuning& to) { value.read(to, value.text(from)); }

std::string known_preset_keys() {
  std::vector<std::string_view> keys;
  std::ranges::transform(tuning_values(), std::back_inserter(keys), &TuningValue::key);
  return joined(keys);
}

std::string presets_as_markdown() {
  std::string table = "| key | meaning |\n|---|---|\n";
  for (const TuningValue& value : tuning_values()) {
    table += "| `" + std::string(value.key) + "` | ";
    table += value.option.empty() ? description(value) : "as `" + std::string(value.option_name()) + "`";
    if (!value.option.empty() && !value.zero.empty()) table += "; 0: " + std::string(value.zero);
    table += " |\n";
  }
  return table;
}

}  // namespace throng::app
