#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "app/settings/option_values.h"
#include "app/settings/settings.h"

namespace throng::app {

/// The part of a number's range that the overlay's track shows, and how the number is written there.
struct Track {
  double least = 0, most = 0;  ///< both 0: the whole range
  int decimals = 0;
  bool logarithmic = false;
  const char* zero_word = nullptr;  ///< written instead of 0
  const char* suffix = "";          ///< the unit
};

/// A value of the tuning. The table of all of them, tuning_values(), is the only place that says a value's name, range,
/// default and meaning: the command line, its help, presets, `--set`, recordings, the overlay and READMEs read it.
struct TuningValue {
  enum class Form : std::uint8_t { number, on_off, word };

  std::string_view key = {};      ///< the key in JSON and of `--set`
  const char* label = "";         ///< the name in the panel; empty: the panel has no row of it
  std::string_view group = {};    ///< the heading above the option in the help
  std::string_view option = {};   ///< the option in the help, "--agents N"; empty: the command line has none
  std::string_view help = {};     ///< {values} and {default} stand for the allowed values and the default
  double least = 0, most = 0;     ///< the range of a number
  std::string_view zero = {};     ///< the meaning of 0, "all cores", which the option does not take
  bool option_does_more = false;  ///< the option also changes other values
  bool only_schedules = false;    ///< poses do not depend on it: a replay takes it from the command line
  bool device_decides = false;    ///< a window starts with another value on some devices unless it is given
  Track track = {};
  Form form = Form::number;
  std::span<const char* const> words = {};  ///< the words of an enumeration, in its order
  std::string values = {};                  ///< all that the option takes, as a phrase
  /// Both read a text into a tuning, or complain. `read` reads the text of presets and `--set`; `read_option` reads the
  /// option's text.
  std::function<Complaint(Tuning&, const std::string&)> read = {}, read_option = {};
  std::function<std::string(const Tuning&)> text = {};  ///< it reads back as the same value to the bit

  /// Returns the name in the panel, or else the key in words.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::string_view option_name() const { return option.substr(0, option.find(' ')); }
  [[nodiscard]] std::string_view hint() const { return option.substr(std::min(option.size(), option.find(' ') + 1)); }
};

/// Returns every value of Tuning that is worth keeping, in the order of presets.
std::span<const TuningValue> tuning_values();

/// Returns the row with that key or option, which must be there.
const TuningValue& tuning_value(std::string_view key_or_option);

/// Returns the row with that key; null where there is none.
const TuningValue* find_tuning_value(std::string_view key);

/// Returns the sentence about the option, with range and default.
std::string description(const TuningValue& value);

/// Puts the value in `from` into `to`.
void copy_value(const TuningValue& value, const Tuning& from, Tuning& to);

/// Returns the keys of all values: "scene, agents, seed ...".
std::string known_preset_keys();

/// Returns the table of all keys in app/commands/command_line/README.md.
std::string presets_as_markdown();

}  // namespace throng::app
