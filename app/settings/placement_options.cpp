#include "app/settings/placement_options.h"

#include "app/settings/choices.h"

namespace throng::app {
namespace {

using anim::GroundRule;
using anim::PlacementChoice;
using anim::UpAxis;

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

/// Reads one part of an option into the placement of all models, or of one.
using ReadAll = Complaint (*)(const std::string& value, PlacementChoice& all);
using ReadOne = Complaint (*)(const std::string& value, ModelPlacement& one);

Complaint read_parts(const std::string& text, ReadAll read_all, ReadOne read_one, PlacementChoice& all,
                     std::vector<ModelPlacement>& some) {
  for (const std::string& part : parts_between_commas(text)) {
    const std::size_t equals = part.rfind('=');
    if (equals == std::string::npos) {
      if (Complaint complaint = read_all(part, all)) return complaint;
      continue;
    }
    ModelPlacement one{.model = part.substr(0, equals)};
    if (one.model.empty()) return "must be VALUE, or NAME=VALUE with the name of a model";
    if (Complaint complaint = read_one(part.substr(equals + 1), one)) return "that of " + one.model + " " + *complaint;
    some.push_back(std::move(one));
  }
  return {};
}

ValueReader parts_reader(ReadAll read_all, ReadOne read_one, PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return [=, &all, &some](const std::string& text) -> Complaint {
    PlacementChoice read = all;
    std::vector<ModelPlacement> more;
    if (Complaint complaint = read_parts(text, read_all, read_one, read, more)) return complaint;
    all = read;
    some.insert(some.end(), more.begin(), more.end());
    return {};
  };
}

}  // namespace

ValueReader up_axis(UpAxis& target) { return axis_into(target); }
ValueReader ground_rule(GroundRule& target) { return ground_into(target); }

ValueReader model_scales(PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return parts_reader(
      [](const std::string& value, PlacementChoice& each) { return scale_above_zero(each.scale)(value); },
      [](const std::string& value, ModelPlacement& one) { return scale_above_zero(one.scale)(value); }, all, some);
}

ValueReader model_up_axes(PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return parts_reader([](const std::string& value, PlacementChoice& each) { return axis_into(each.up)(value); },
                      [](const std::string& value, ModelPlacement& one) { return axis_into(one.up)(value); }, all,
                      some);
}

ValueReader model_grounds(PlacementChoice& all, std::vector<ModelPlacement>& some) {
  return parts_reader([](const std::string& value, PlacementChoice& each) { return ground_into(each.ground)(value); },
                      [](const std::string& value, ModelPlacement& one) { return ground_into(one.ground)(value); }, all,
                      some);
}

}  // namespace throng::app
