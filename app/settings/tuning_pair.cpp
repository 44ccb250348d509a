#include "app/settings/tuning_pair.h"

#include <algorithm>
#include <utility>

#include "app/settings/preset.h"
#include "app/settings/tuning_values.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

Tuning with_looks_of(const Tuning& looks, Tuning tuning) {
  tuning.paused = looks.paused;
  tuning.inspection = looks.inspection;
  return tuning;
}

std::string with_unit(const TuningValue& value, const Tuning& tuning) {
  std::string text = value.text(tuning);
  if (value.key.ends_with("_ns")) return text + " ns";  // the panel shows one of these in microseconds
  if (text == "0" && value.track.zero_word != nullptr) return value.track.zero_word;
  return text + value.track.suffix;
}

bool can_name_a_tuning(const std::string& name) {
  const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < ' '; };
  return name.size() <= TuningPair::longest_name && std::ranges::none_of(name, is_control);
}

void read_names(const JsonObject& object, std::array<std::string, 2>& names) {
  std::vector<std::string> read(names.begin(), names.end());
  object.texts("names", read);
  if (read.size() == names.size() && std::ranges::all_of(read, can_name_a_tuning)) {
    std::ranges::move(read, names.begin());
  } else {
    object.wrong("names", "two texts of a line, at most " + std::to_string(TuningPair::longest_name) + " bytes each");
  }
}

}  // namespace

void TuningPair::change_places(Tuning& tuning) {
  if (!other_) return;
  shows_b_ = !shows_b_;
  other_ = std::exchange(tuning, with_looks_of(tuning, *other_));
}

void TuningPair::take_other(const Tuning& tuning, const std::string& name) {
  other_ = tuning;
  names.at(1 - in_use()) = name.substr(0, longest_name);
}

void TuningPair::forget_other() {
  names = {names.at(in_use()), ""};
  other_.reset();
  shows_b_ = false;
}

std::string TuningPair::title(std::size_t place) const {
  const std::string& name = names.at(place);
  return letters.at(place) + (name.empty() ? "" : ": " + name);
}

Json to_json(const TuningPair& pair) {
  Json json = {{"in_use", pair.letter_in_use()}, {"names", Json::array({pair.names[0], pair.names[1]})}};
  if (pair.has_two()) json["other"] = to_json(Preset{.tuning = pair.other(), .camera = {}});
  return json;
}

Complaint from_json(const Json& json, TuningPair& pair) {
  std::optional<std::string> complaint;
  const JsonObject object("compare", json, {"in_use", "names", "other"}, complaint);
  std::string in_use = TuningPair::letters.front();
  object.text("in_use", in_use);
  const bool shows_b = in_use == TuningPair::letters.back();
  if (!shows_b && in_use != TuningPair::letters.front()) object.wrong("in_use", "A or B");
  if (shows_b) object.need({"other"});
  std::array<std::string, 2> names;
  read_names(object, names);
  std::optional<Tuning> waits;
  if (object.has("other")) {
    Preset other;
    if (const Complaint wrong = from_json(object["other"], other)) object.complain("\"other\": " + *wrong);
    waits = other.tuning;
  }
  TuningPair taken(std::move(waits), shows_b);
  taken.names = std::move(names);
  if (!complaint) pair = std::move(taken);
  return complaint;
}

std::vector<TuningDifference> differences(const Tuning& first, const Tuning& second) {
  const Tuning compared = with_looks_of(first, second);
  std::vector<TuningDifference> found;
  for (const TuningValue& value : tuning_values()) {
    if (value.text(first) == value.text(compared)) continue;
    found.push_back({value.key, with_unit(value, first), with_unit(value, compared)});
  }
  return found;
}

}  // namespace throng::app
