// Reads the options that name models: casts with shares, sizes and places.
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/settings/choices.h"
#include "app/settings/option_values.h"

namespace throng::app {
namespace {

using anim::GroundRule;
using anim::PlacementChoice;
using anim::UpAxis;

bool is_there(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

Complaint read_entry(const std::string& text, CastEntry& entry) {
  const std::size_t star = is_there(text) ? std::string::npos : text.rfind('*');
  entry.file = text.substr(0, star);
  if (entry.file.empty()) return "must be FILE*SHARE, with commas between several; FILE may be a folder";
  if (star == std::string::npos) return {};
  const Complaint complaint = read_number(text.substr(star + 1), least_share, most_share, entry.share.emplace());
  return complaint ? Complaint("the share of " + entry.file + " " + *complaint + ", as in " + entry.file + "*2")
                   : Complaint();
}

template <typename Value, std::size_t count>
std::vector<std::pair<std::string, Value>> choices_from(const std::array<const char*, count>& words,
                                                        std::size_t first) {
  std::vector<std::pair<std::string, Value>> choices;
  for (std::size_t i = first; i < count; ++i) choices.emplace_back(words.at(i), static_cast<Value>(i));
  return choices;
}

// A guess has no word on the command line: it is the default.
template <typename Target>
ValueReader ground_into(Target& target) {
  return choice<GroundRule>(target, choices_from<GroundRule>(ground_words, 1));
}

template <typename Target>
ValueReader axis_into(Target& target) {
  return choice<UpAxis>(target, choices_from<UpAxis>(up_axis_words, 0));
}

/// Reads parts into the placement of all models, or of one. `reader_into` makes the reader of a value for either.
template <typename ReaderInto>
ValueReader parts_reader(ReaderInto reader_into, PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return [=, &all, &some](const std::string& text) -> Complaint {
    PlacementChoice read = all;
    std::vector<ModelPlacement> more;
    for (const std::string& part : parts_between_commas(text)) {
      const std::size_t equals = part.rfind('=');
      if (equals == std::string::npos) {
        if (Complaint complaint = reader_into(read)(part)) return complaint;
        continue;
      }
      ModelPlacement& one = more.emplace_back();
      one.model = part.substr(0, equals);
      if (one.model.empty()) return "must be VALUE, or NAME=VALUE with the name of a model";
      const Complaint complaint = reader_into(one)(part.substr(equals + 1));
      if (complaint) return "that of " + one.model + " " + *complaint;
    }
    all = read;
    some.insert(some.end(), more.begin(), more.end());
    return {};
  };
}

}  // namespace

ValueReader cast_entries(std::vector<CastEntry>& target) {
  return [&target](const std::string& text) -> Complaint {
    std::vector<CastEntry> entries;
    for (const std::string& part : parts_between_commas(text)) {
      if (Complaint complaint = read_entry(part, entries.emplace_back())) return complaint;
    }
    if (entries.size() > most_models) return "must be " + std::to_string(most_models) + " files and folders at most";
    target = std::move(entries);
    return {};
  };
}

ValueReader cast_or_rules(std::vector<CastEntry>& target, std::string& rules) {
  return [&rules, entries = cast_entries(target)](const std::string& text) -> Complaint {
    if (!text.ends_with(".json")) return entries(text);
    rules = text;
    return {};
  };
}

ValueReader up_axis(UpAxis& target) { return axis_into(target); }
ValueReader ground_rule(GroundRule& target) { return ground_into(target); }

ValueReader model_scales(PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return parts_reader([](auto& placement) { return scale_above_zero(placement.scale); }, all, some);
}

ValueReader model_up_axes(PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return parts_reader([](auto& placement) { return axis_into(placement.up); }, all, some);
}

ValueReader model_grounds(PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return parts_reader([](auto& placement) { return ground_into(placement.ground); }, all, some);
}

}  // namespace throng::app
