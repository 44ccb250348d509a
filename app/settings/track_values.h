#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "app/settings/option_values.h"
#include "app/settings/settings.h"
#include "engine/base/json/json.h"

namespace throng::app {

/// A value of a recorded crowd. The table of all of them, track_values(), is the only place that says a value's name
/// and meaning: the command line, its help, crowd files and the copied command line read it.
struct TrackValue {
  enum class Kind : std::uint8_t { file, reading, playing };
  enum class Form : std::uint8_t { text, number, on_off, file_name };

  std::string_view key = {};     ///< the key in JSON
  std::string_view option = {};  ///< the option in the help, "--walls FILE"; empty: another option says it too
  std::string_view help = {};
  Kind kind = Kind::reading;
  Form form = Form::text;
  std::function<ValueReader(TrajectoryOptions&)> reader = {};
  /// Its text reads back as the same value to the bit; empty where the value is not set.
  std::function<std::string(const TrajectoryOptions&)> text = {};

  /// Returns whether the option has no value, or one after `=` alone.
  [[nodiscard]] bool is_flag() const { return form == Form::on_off; }
  [[nodiscard]] std::string option_name() const { return std::string(option.substr(0, option.find_first_of(" ["))); }
  [[nodiscard]] std::string hint() const {
    return std::string(option.substr(std::min(option.size(), option_name().size() + (is_flag() ? 0 : 1))));
  }
};

/// Returns every value of TrajectoryOptions: the file, then how it is read, then how it is played.
std::span<const TrackValue> track_values();

/// Returns one flat JSON object with the keys of track_values(); values that are not set are left out.
Json to_json(const TrajectoryOptions& tracks);
/// Reads such an object, which must have a "file". A complaint names the key and what is allowed.
Complaint from_json(const Json& json, TrajectoryOptions& tracks);

}  // namespace throng::app
