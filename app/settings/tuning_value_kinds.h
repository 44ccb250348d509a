#pragma once

#include <cassert>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/settings/tuning_values.h"

/// Makes the rows of the table: each reads and writes its value by the kind of the value.
namespace throng::app {

/// Makes a function that finds a member of a Tuning, const or not: at(&Tuning::lod, &LodRules::smooth).
template <typename... Members>
auto at(Members... members) {
  return [=](auto& tuning) -> auto& { return (tuning.*....*members); };
}

template <typename Member>
TuningValue number(TuningValue value, Member member) {
  using Number = std::remove_reference_t<decltype(member(std::declval<Tuning&>()))>;
  const double least = value.least, most = value.most, first = value.zero.empty() ? least : 1;
  value.form = TuningValue::Form::number;
  value.values = range_text<Number>(first, most);
  value.read = [=](Tuning& tuning, const std::string& text) {
    return read_number<Number>(text, least, most, member(tuning));
  };
  value.read_option = [=](Tuning& tuning, const std::string& text) {
    return read_number<Number>(text, first, most, member(tuning));
  };
  value.text = [=](const Tuning& tuning) { return shortest_text(member(tuning)); };
  return value;
}

/// Makes the row of a number above 0; a preset has 0 for no limit.
template <typename Member>
TuningValue limit(TuningValue value, const char* unit, Member member) {
  value = number(std::move(value), member);
  value.read_option = [=](Tuning& tuning, const std::string& text) {
    return number_above_zero(member(tuning), unit)(text);
  };
  return value;
}

template <typename Member>
TuningValue on_off(TuningValue value, Member member) {
  value.form = TuningValue::Form::on_off;
  value.values = "on or off";
  value.read_option = [=](Tuning& tuning, const std::string& text) { return on_or_off(member(tuning))(text); };
  value.read = [=](Tuning& tuning, const std::string& text) {  // a preset says true or false
    return on_or_off(member(tuning))(text == "true" ? "on" : text == "false" ? "off" : text);
  };
  value.text = [=](const Tuning& tuning) { return std::string(member(tuning) ? "on" : "off"); };
  return value;
}

template <typename Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// Makes the row of one of a few values. Where several words mean one value, the first is written. The option does not
/// take the word of `zero`.
template <typename Value, typename Member>
TuningValue one_of(TuningValue value, Member member, const Choices<Value>& choices) {
  const Choices<Value> taken(choices.begin() + (value.zero.empty() ? 0 : 1), choices.end());
  std::vector<std::string> names;
  for (const auto& [name, unused] : taken) names.push_back(name);
  value.form = std::is_integral_v<Value> && !value.zero.empty() ? TuningValue::Form::number : TuningValue::Form::word;
  value.values = joined(names, ", ", " or ");
  value.read = [=](Tuning& tuning, const std::string& text) { return choice<Value>(member(tuning), choices)(text); };
  value.read_option = [=](Tuning& tuning, const std::string& text) {
    return choice<Value>(member(tuning), taken)(text);
  };
  value.text = [=](const Tuning& tuning) -> std::string {
    for (const auto& [name, each] : choices) {
      if (each == member(tuning)) return name;
    }
    assert(false);
    return {};
  };
  return value;
}

/// Makes the row of an enumeration, with a word for each enumerator in its order.
template <std::size_t count, typename Member>
TuningValue word(TuningValue value, Member member, const std::array<const char*, count>& words) {
  using Value = std::remove_reference_t<decltype(member(std::declval<Tuning&>()))>;
  Choices<Value> choices;
  for (std::size_t i = 0; i < count; ++i) choices.emplace_back(words[i], static_cast<Value>(i));
  value.words = words;
  return one_of<Value>(std::move(value), member, choices);
}

}  // namespace throng::app
