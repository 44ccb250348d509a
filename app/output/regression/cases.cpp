#include "app/output/regression/cases.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "app/files/nearest_names.h"
#include "app/settings/option_values.h"
#include "app/settings/tuning_values.h"
#include "engine/base/files/input_file.h"
#include "engine/base/json/json.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;
using Keys = std::initializer_list<std::string_view>;

constexpr std::size_t most_cases = 10'000;

/// Complains about a key that is none of `keys`, and names the key that was meant, or all.
Complaint unknown_key_in(const Json& object, Keys keys) {
  const Json::Member* const other = object.member_beside(keys);
  if (other == nullptr) return {};
  const std::vector<std::string> names(keys.begin(), keys.end());
  const auto meant = name_meant(other->key, names);
  return "unknown key " + in_quotes(other->key) + "; " +
         (meant ? "is \"" + *meant + "\" meant?" : "the keys are " + joined(names));
}

std::string must_be(std::string_view key, const std::string& expected) {
  return '"' + std::string(key) + "\" must be " + expected;
}

/// Reads a text, or a list of some.
Complaint read_texts(const Json& object, std::string_view key, std::vector<std::string>& texts) {
  if (!object.contains(key)) return {};
  const Json& value = object[key];
  if (value.is<std::string>()) {
    texts = {value.get<std::string>()};
  } else if (value.is<std::vector<std::string>>()) {
    texts = value.get<std::vector<std::string>>();
  } else {
    return must_be(key, "a text, or a list of texts");
  }
  if (std::ranges::any_of(texts, &std::string::empty)) return '"' + std::string(key) + "\" must not be empty";
  if (std::ranges::any_of(texts, [](const auto& text) { return text.find('\0') != std::string::npos; })) {
    return '"' + std::string(key) + "\" must not have a letter of no value";
  }
  return {};
}

Complaint read_text_of(const Json& object, std::string_view key, std::string& text) {
  std::vector<std::string> texts;
  if (Complaint complaint = read_texts(object, key, texts)) return complaint;
  if (texts.size() != (object.contains(key) ? 1 : 0)) return must_be(key, "a text");
  if (!texts.empty()) text = texts.front();
  return {};
}

Complaint read_limit(const Json& tolerance, std::string_view key, double most, std::optional<DifferenceLimit>& limit) {
  if (!tolerance.contains(key)) return {};
  const Json& object = tolerance[key];
  if (!object.is_object()) return must_be(key, "an object with \"most\" and \"because\"");
  if (Complaint complaint = unknown_key_in(object, {"most", "because"}))
    return '"' + std::string(key) + "\": " + *complaint;
  const Json& number = object["most"];
  const double value = number.is_number() ? number.get<double>() : -1.0;
  if (!(value >= 0 && value <= most)) {
    return '"' + std::string(key) + "\": " + must_be("most", "a number, 0 to " + shortest_text(most));
  }
  limit.emplace().most = value;
  if (Complaint complaint = read_text_of(object, "because", limit->because)) return complaint;
  if (limit->because.empty()) return '"' + std::string(key) + "\": \"because\" must say why it is as large as that";
  return {};
}

Complaint read_tolerance(const Json& json, Tolerance& tolerance) {
  if (!json.is_object()) return must_be("tolerance", "an object with \"mean\", \"worst_block\" and \"share\"");
  if (Complaint complaint = unknown_key_in(json, {"mean", "worst_block", "share"})) return complaint;
  Complaint complaint = read_limit(json, "mean", 255, tolerance.mean);
  if (!complaint) complaint = read_limit(json, "worst_block", 255, tolerance.worst_block);
  return complaint ? complaint : read_limit(json, "share", 1, tolerance.share);
}

/// Returns whether a name can name a file on every system.
bool is_a_good_name(const std::string& name) {
  constexpr std::size_t most_letters = 100;
  const auto is_good = [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '-' || letter == '_' || letter == '.';
  };
  return !name.empty() && name.size() <= most_letters && name.front() != '.' && name.front() != '-' &&
         std::ranges::all_of(name, is_good);
}

/// Reads one case; keys that it lacks come from the defaults.
class CaseReader {
 public:
  CaseReader(const RegressionCases& all, const Json& json, const Json& defaults)
      : all_(all), json_(json), defaults_(defaults) {}

  Complaint read(RegressionCase& into) const {
    if (Complaint complaint =
            unknown_key_in(json_, {"name", "models", "preset", "scene", "recording", "trajectories", "agents", "frame",
                                   "camera", "size", "context", "tolerance", "options", "expected"})) {
      return complaint;
    }
    if (Complaint complaint = read_words(into.words)) return complaint;
    if (Complaint complaint = read_contexts(into.contexts)) return complaint;
    if (value("tolerance") != nullptr) {
      if (Complaint complaint = read_tolerance(*value("tolerance"), into.tolerance)) return complaint;
    }
    std::string expected;
    if (Complaint complaint = read_text_of(json_, "expected", expected)) return complaint;
    if (!expected.empty() && !expected.ends_with(".png")) return must_be("expected", "a file that ends in .png");
    into.expected = expected.empty() ? all_.pictures / (into.name + ".png") : all_.folder / expected;
    return {};
  }

 private:
  /// Returns a member of the case, else of the defaults; null if none has it. The crowd of a file brings its scene and
  /// its people, which the defaults do not change.
  const Json* value(std::string_view key) const {
    if (json_.contains(key)) return &json_[key];
    const bool is_of_file = json_.contains("recording") || json_.contains("trajectories");
    const bool is_left_out = is_of_file && (key == "scene" || key == "agents");
    return defaults_.contains(key) && !is_left_out ? &defaults_[key] : nullptr;
  }
  const Json& object_with(std::string_view key) const { return json_.contains(key) ? json_ : defaults_; }

  Complaint read_words(std::vector<std::string>& words) const {
    if (Complaint complaint = read_texts(object_with("models"), "models", words)) return complaint;
    Tuning tuning;
    DemoOptions options;
    const auto scene = [&](const std::string& text) { return tuning_value("--scene").read_option(tuning, text); };
    const auto agents = [&](const std::string& text) { return tuning_value("--agents").read_option(tuning, text); };
    std::string unchecked;
    const std::initializer_list<std::pair<std::string_view, std::pair<const char*, ValueReader>>> all = {
        {"preset", {"--preset", any_text(unchecked)}},
        {"scene", {"--scene", scene}},
        {"recording", {"--replay", file_name(unchecked)}},
        {"trajectories", {"--trajectories", file_name(unchecked)}},
        {"agents", {"--agents", agents}},
        {"frame", {"--frames", whole_number(options.frames, 1, std::numeric_limits<int>::max())}},
        {"camera", {"--camera", camera(options)}},
        {"size", {"--size", image_size(options.width, options.height)}}};
    for (const auto& [key, option] : all) {
      if (Complaint complaint = read_option(key, option.first, option.second, words)) return complaint;
    }
    std::vector<std::string> more;
    if (Complaint complaint = read_texts(object_with("options"), "options", more)) return complaint;
    if (Complaint complaint = own_option_in(more)) return complaint;
    words.insert(words.end(), more.begin(), more.end());
    return {};
  }

  Complaint read_option(std::string_view key, const char* option, const ValueReader& reader,
                        std::vector<std::string>& words) const {
    const Json* const json = value(key);
    if (json == nullptr) return {};
    if (!json->is<std::string>() && !json->is<std::int64_t>()) return must_be(key, "a text or a whole number");
    const std::string text = json->is<std::string>() ? json->get<std::string>() : json->dump();
    if (text.find('\0') != std::string::npos) return must_be(key, "a text without a letter of no value");
    if (const Complaint complaint = reader(text)) return '"' + std::string(key) + "\" " + *complaint;
    words.insert(words.end(), {option, text});
    return {};
  }

  /// Refuses options that the command gives by itself.
  static Complaint own_option_in(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      const std::string option = word.substr(0, word.find('='));
      if (option == "--headless" || option == "--software" || option == "--screenshot") {
        return "\"options\" must not have " + option + ", which throng check gives by itself";
      }
    }
    return {};
  }

  Complaint read_contexts(std::vector<ContextKind>& contexts) const {
    contexts = {ContextKind::egl};
    const Json* const json = value("context");
    if (json == nullptr) return {};
    const std::string text = json->is<std::string>() ? json->get<std::string>() : std::string();
    return choice<std::vector<ContextKind>>(contexts, {{"egl", {ContextKind::egl}},
                                                       {"osmesa", {ContextKind::osmesa}},
                                                       {"both", {ContextKind::egl, ContextKind::osmesa}}})(text)
               ? must_be("context", "egl, osmesa or both")
               : Complaint();
  }

  const RegressionCases& all_;
  const Json& json_;
  const Json& defaults_;
};

Complaint read_name(const Json& json, std::span<const RegressionCase> before, std::string& name) {
  if (!json.is_object()) return "it must be an object";
  if (!json.contains("name")) return "\"name\" is missing";
  if (Complaint complaint = read_text_of(json, "name", name)) return complaint;
  if (!is_a_good_name(name)) {
    return must_be("name", "1 to 100 letters, digits, -, _ and ., with a letter or digit first");
  }
  if (std::ranges::find(before, name, &RegressionCase::name) != before.end()) {
    return "another case has that name; give each its own";
  }
  return {};
}

Complaint read_each_case(const Json& json, RegressionCases& all) {
  const Json& list = json["cases"];
  if (!list.is_array() || list.elements().empty() || list.elements().size() > most_cases) {
    return must_be("cases", "a list of 1 to " + std::to_string(most_cases) + " cases");
  }
  for (const Json& each : list.elements()) {
    RegressionCase next;
    const std::string place = "case " + std::to_string(all.cases.size() + 1);
    if (const Complaint complaint = read_name(each, all.cases, next.name)) {
      return place + (next.name.empty() ? "" : " " + in_quotes(next.name)) + ": " + *complaint;
    }
    if (const Complaint complaint = CaseReader(all, each, json["defaults"]).read(next)) {
      return place + " " + in_quotes(next.name) + ": " + *complaint;
    }
    all.cases.push_back(std::move(next));
  }
  return {};
}

/// Reads the defaults alone, so that a complaint about them does not blame the first case.
Complaint read_defaults(const Json& json, RegressionCases& all) {
  if (!json.contains("defaults")) return {};
  const Json& defaults = json["defaults"];
  if (!defaults.is_object()) return must_be("defaults", "an object with keys of cases");
  for (const char* const own : {"name", "expected"}) {
    if (defaults.contains(own)) return "defaults: \"" + std::string(own) + "\" is for single cases; leave it out";
  }
  RegressionCase unused;
  if (const Complaint complaint = CaseReader(all, defaults, Json()).read(unused)) return "defaults: " + *complaint;
  all.tolerance = unused.tolerance;
  return {};
}

Complaint read_all(const Json& json, RegressionCases& all) {
  if (!json.is_object()) return "it must be an object with \"cases\"";
  if (Complaint complaint = unknown_key_in(json, {"pictures", "bits", "defaults", "cases"})) return complaint;
  std::string pictures = "expected";
  if (Complaint complaint = read_text_of(json, "pictures", pictures)) return complaint;
  all.pictures = all.folder / pictures;
  if (json.contains("bits")) {
    if (!json["bits"].is_whole(1, 8)) return must_be("bits", "a whole number, 1 to 8");
    all.bits = json["bits"].get<int>();
  }
  if (Complaint complaint = read_defaults(json, all)) return complaint;
  return read_each_case(json, all);
}

}  // namespace

Result<RegressionCases> parse_cases(std::string_view text, const fs::path& folder) {
  const auto json = parse_json(text);
  if (!json) return Error{json.error().message + "; mend it there"};
  RegressionCases all;
  all.folder = folder;
  if (const Complaint complaint = read_all(*json, all)) return Error{*complaint};
  return all;
}

Result<RegressionCases> read_cases(const fs::path& file) {
  const auto text = read_text(file, "a file of cases (.json)", most_json_bytes);
  if (!text) return Error{file.string() + ": " + text.error().message};
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  auto cases = parse_cases(*text, (error ? file : whole).parent_path());
  return cases ? std::move(cases) : Error{file.string() + ": " + cases.error().message};
}

}  // namespace throng::app
