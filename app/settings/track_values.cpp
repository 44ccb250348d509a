#include "app/settings/track_values.h"

#include <utility>
#include <vector>

#include "app/files/json_file.h"
#include "app/settings/preset.h"

namespace throng::app {
namespace {

using Form = TrackValue::Form;
using Kind = TrackValue::Kind;

constexpr double most_rows_a_second = 10'000.0;
constexpr double farthest_time = 1e12;  // seconds
constexpr double fastest_rate = 100.0;

template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

const Words<double> time_words{{"s", 1.0}, {"ms", 1e3}, {"us", 1e6}, {"ns", 1e9}, {"min", 1.0 / 60.0}};
const Words<double> length_words{{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"km", 1000.0}, {"ft", 0.3048}};
const Words<TrackHeight> height_words{
    {"head", TrackHeight::head}, {"ground", TrackHeight::ground}, {"none", TrackHeight::none}};
const Words<TrackAngle> angle_words{{"degrees", TrackAngle::degrees},
                                    {"radians", TrackAngle::radians},
                                    {"north", TrackAngle::north},
                                    {"none", TrackAngle::none}};
const Words<TrackUp> up_words{{"y", TrackUp::y}, {"z", TrackUp::z}};

template <typename Value>
std::string word_for(const Words<Value>& words, const Value& value) {
  const auto found = std::ranges::find(words, value, &std::pair<std::string, Value>::second);
  return found == words.end() ? std::string() : found->first;
}

std::string number_text(const std::optional<double>& number) { return number ? shortest_text(*number) : std::string(); }

ValueReader track_rate(std::optional<double>& target) {
  return [&target](const std::string& text) -> Complaint {
    double rate = 0.0;
    const Complaint complaint = read_number(text, -fastest_rate, fastest_rate, rate);
    if (complaint || rate == 0.0) return "must be a number, -100 to 100, and not 0";
    target = rate;
    return {};
  };
}

ValueReader track_part(std::optional<std::pair<double, double>>& target) {
  return [&target](const std::string& text) -> Complaint {
    const std::size_t comma = text.find(',');
    std::pair<double, double> part;
    const bool is_part = comma != std::string::npos &&
                         !read_number(text.substr(0, comma), -farthest_time, farthest_time, part.first) &&
                         !read_number(text.substr(comma + 1), -farthest_time, farthest_time, part.second);
    if (!is_part) return "must be two numbers of seconds, 12.5,40";
    target = part;
    return {};
  };
}

/// Reads a word for a unit, or the metres of one.
ValueReader length_unit(std::optional<double>& target) {
  return [&target](const std::string& text) -> Complaint {
    std::optional<double> number;
    if (!choice<double>(number, length_words)(text) || !real_number(number, 1e-6, 1e6)(text)) {
      target = number;
      return {};
    }
    return "must be m, cm, mm, km, ft or the metres of a unit, 0.000001 to 1000000";
  };
}

TrackValue file_value() {
  return {.key = "file",
          .option = "--trajectories FILE|-",
          .help =
              "People, places and times: JuPedSim, Vadere, Jülich text, SUMO, Pathfinder, obsmat, ndjson or any "
              "CSV; -: rows of standard input as they come, for at most --agents people at once (1000)",
          .kind = Kind::file,
          .form = Form::file_name,
          .reader = [](TrajectoryOptions& tracks) { return any_text(tracks.file); },
          .text = [](const TrajectoryOptions& tracks) { return tracks.file; }};
}

std::vector<TrackValue> unit_values() {
  return {
      {.key = "fps",
       .option = "--fps N[/N]",
       .help = "Frames a second of its rows, where they have frames (what the file says)",
       .form = Form::number,
       .reader = [](auto& tracks) { return frame_rate(tracks.reading.fps, 0.001, most_rows_a_second); },
       .text = [](const auto& tracks) { return number_text(tracks.reading.fps); }},
      {.key = "time_unit",
       .option = "--time-unit s|ms|us|ns|min",
       .help = "The unit of its times, where rows have times (by name of the column)",
       .reader = [](auto& tracks) { return choice<double>(tracks.reading.times_a_second, time_words); },
       .text = [](const auto& tracks) { return word_for(time_words, tracks.reading.times_a_second.value_or(0.0)); }},
      {.key = "unit",
       .option = "--unit m|cm|mm|km|ft|X",
       .help = "The unit of its places, or how many metres it is (told apart)",
       .form = Form::number,
       .reader = [](auto& tracks) { return length_unit(tracks.reading.metres_a_unit); },
       .text = [](const auto& tracks) { return number_text(tracks.reading.metres_a_unit); }},
  };
}

std::vector<TrackValue> meaning_values() {
  return {
      {.key = "height",
       .option = "--height head|ground|none",
       .help = "What its third coordinate is the height of; none: leave it out (by format)",
       .reader = [](auto& tracks) { return choice<TrackHeight>(tracks.reading.height, height_words); },
       .text = [](const auto& tracks) { return word_for(height_words, tracks.reading.height); }},
      {.key = "angle",
       .option = "--angle degrees|radians|north|none",
       .help = "What its angles are: from +x, or degrees clockwise from north; none: leave them out (told apart)",
       .reader = [](auto& tracks) { return choice<TrackAngle>(tracks.reading.angle, angle_words); },
       .text = [](const auto& tracks) { return word_for(angle_words, tracks.reading.angle); }},
      {.key = "up",
       .reader = [](auto& tracks) { return choice<TrackUp>(tracks.reading.up, up_words); },
       .text = [](const auto& tracks) { return std::string(tracks.reading.up == TrackUp::y ? "y" : ""); }},
      {.key = "lenient",
       .option = "--lenient",
       .help = "Skip rows that are wrong, and count them",
       .form = Form::on_off,
       .reader = [](auto& tracks) { return on_or_off(tracks.reading.lenient); },
       .text = [](const auto& tracks) { return std::string(tracks.reading.lenient ? "on" : ""); }},
  };
}

std::vector<TrackValue> time_values() {
  return {
      {.key = "start",
       .option = "--start T",
       .help = "Seconds of its clock at which the crowd begins (its first row)",
       .kind = Kind::playing,
       .form = Form::number,
       .reader = [](auto& tracks) { return real_number(tracks.start, -farthest_time, farthest_time); },
       .text = [](const auto& tracks) { return number_text(tracks.start); }},
      {.key = "rate",
       .option = "--track-rate X",
       .help = "Seconds of its clock a second, -100 to 100; below 0: backwards (1)",
       .kind = Kind::playing,
       .form = Form::number,
       .reader = [](auto& tracks) { return track_rate(tracks.rate); },
       .text = [](const auto& tracks) { return number_text(tracks.rate); }},
      {.key = "part",
       .option = "--track-part T,T",
       .help = "Play from one to the other second of its clock only (all of it)",
       .kind = Kind::playing,
       .reader = [](auto& tracks) { return track_part(tracks.part); },
       .text =
           [](const auto& tracks) {
             if (!tracks.part) return std::string();
             return shortest_text(tracks.part->first) + "," + shortest_text(tracks.part->second);
           }},
      {.key = "repeat",
       .option = "--track-repeat[=on|off]",
       .help = "Begin anew at the end of the part, or stay there (on in a window, else off)",
       .kind = Kind::playing,
       .form = Form::on_off,
       .reader =
           [](auto& tracks) {
             return choice<bool>(tracks.repeats, {{"on", true}, {"off", false}});
           },
       .text = [](const auto& tracks) { return std::string(!tracks.repeats   ? ""
                                                           : *tracks.repeats ? "on"
                                                                             : "off"); }},
  };
}

std::vector<TrackValue> all_values() {
  std::vector<TrackValue> all{file_value(),
                              {.key = "walls",
                               .option = "--walls FILE",
                               .help = "Walls and floors: WKT, .scenario or .floor (what the file has)",
                               .form = Form::file_name,
                               .reader = [](TrajectoryOptions& tracks) { return file_name(tracks.reading.walls); },
                               .text = [](const TrajectoryOptions& tracks) { return tracks.reading.walls; }}};
  for (const auto& more : {unit_values(), meaning_values(), time_values()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

Json json_of_text(const TrackValue& value, const std::string& text) {
  if (value.form == Form::on_off) return text == "on";
  if (value.form == Form::file_name) return name_json(text);
  return value.form == Form::number ? *parse_json(text) : Json(text);
}

Complaint take_json(const TrackValue& value, const Json& json, TrajectoryOptions& tracks) {
  const std::string key(value.key);
  if (value.form != Form::file_name) return take_value(value.reader(tracks), key, json);
  std::string file;
  if (!read_name(json, file)) return "\"" + key + "\" must be the name of a file";
  const Complaint wrong = value.reader(tracks)(file);
  return wrong ? Complaint("\"" + key + "\" " + *wrong) : Complaint();
}

}  // namespace

std::span<const TrackValue> track_values() {
  static const std::vector<TrackValue> all = all_values();
  return all;
}

Json to_json(const TrajectoryOptions& tracks) {
  Json json = Json::object();
  for (const TrackValue& value : track_values()) {
    const std::string text = value.text(tracks);
    if (!text.empty()) json[value.key] = json_of_text(value, text);
  }
  return json;
}

Complaint from_json(const Json& json, TrajectoryOptions& tracks) {
  if (!json.is_object()) return "must be an object with a \"file\"";
  TrajectoryOptions taken;
  for (const auto& [key, member] : json.members()) {
    const auto value = std::ranges::find(track_values(), key, &TrackValue::key);
    if (value == track_values().end()) {
      std::vector<std::string> known;
      for (const TrackValue& each : track_values()) known.emplace_back(each.key);
      return "unknown key \"" + key + "\"; it knows " + joined(known);
    }
    if (const Complaint wrong = take_json(*value, member, taken)) return wrong;
  }
  if (taken.file.empty()) return "\"file\" is missing";
  tracks = std::move(taken);
  return {};
}

}  // namespace throng::app
