#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "app/settings/option_values.h"
#include "app/settings/settings.h"

namespace throng::app {

/// A value of the tuning as presets, recordings, `--set` and "copy as command line" write it.
struct PresetField {
  enum class Form : std::uint8_t { number, on_off, word };

  std::string_view key;     ///< in JSON, and of `--set`
  std::string_view option;  ///< of the command line, which takes the same text; empty: there is none
  std::string_view unsaid;  ///< the text that the option does not take, as it is what no option means
  Form form;
  std::function<ValueReader(Tuning&)> reader;      ///< takes the text into a tuning, or complains
  std::function<std::string(const Tuning&)> text;  ///< exact: read again, it is the same value to the bit
};

/// Every value of Tuning, in its order. A new member of Tuning gets a row here.
std::span<const PresetField> preset_fields();

/// The row with that key or that option; null where there is none.
const PresetField* find_preset_field(std::string_view key_or_option);

/// Puts the value of `field` in `from` into `to`.
void copy_field(const PresetField& field, const Tuning& from, Tuning& to);

/// "agents, scene, seed ...".
std::string known_preset_keys();

}  // namespace throng::app
