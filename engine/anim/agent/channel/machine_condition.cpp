#include "engine/anim/agent/channel/machine_condition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

#include "engine/base/text/plain_text.h"

namespace throng::anim {
namespace {

using Is = StateMachine::Condition::Is;
using Kind = MachineDescription::Input::Kind;

constexpr std::string_view negation = "not";

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Takes the next word off the front of a text: a name, a number or a comparison; empty at the end.
std::string_view take_word(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const bool is_word = !text.empty() && is_word_character(text.front());
  const bool is_comparison = !text.empty() && (text.front() == '<' || text.front() == '>');
  std::size_t size = 0;
  while (size < text.size() && text[size] != ' ') {
    if (is_word && !is_word_character(text[size])) break;
    if (is_comparison && text[size] != '<' && text[size] != '>' && text[size] != '=') break;
    ++size;
  }
  const std::string_view word = text.substr(0, size);
  text.remove_prefix(size);
  return word;
}

std::optional<Is> comparison_of(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, Is>, 4> all{
      {{"<", Is::less}, {"<=", Is::at_most}, {">", Is::more}, {">=", Is::at_least}}};
  for (const auto& [text, is] : all) {
    if (text == word) return is;
  }
  return std::nullopt;
}

/// Reads the number that is all of the text, and that a float holds.
std::optional<float> number_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());  // a point is a point, whatever the host has set
  float value = 0.0F;
  const bool is_number = static_cast<bool>(stream >> value) && std::isfinite(value);
  return is_number && (stream >> std::ws).eof() ? std::optional(value) : std::nullopt;
}

}  // namespace

bool is_input_name(std::string_view name) {
  return !name.empty() && name != negation && std::ranges::all_of(name, is_word_character);
}

Result<StateMachine::Condition> read_condition(const std::string& text,
                                               std::span<const MachineDescription::Input> inputs) {
  std::string_view rest = text;
  std::string_view name = take_word(rest);
  const bool negated = name == negation;
  if (negated) name = take_word(rest);
  const auto found = std::ranges::find(inputs, name, &MachineDescription::Input::name);
  if (found == inputs.end()) return Error{"names no input: give the machine an input " + in_quotes(name)};
  const auto input = static_cast<std::uint8_t>(found - inputs.begin());
  const std::string_view comparison = take_word(rest);
  if (found->kind != Kind::number) {
    if (!comparison.empty()) return Error{"compares what is on or off: write \"" + found->name + "\" alone"};
    if (negated && found->kind == Kind::trigger) return Error{"waits for a trigger that is not set: use a flag"};
    return StateMachine::Condition{.input = input, .is = negated ? Is::less : Is::more, .value = 0.5F};
  }
  const std::optional<Is> is = comparison_of(comparison);
  const std::optional<float> value = number_of(rest);
  if (negated || !is || !value) {
    return Error{"is no comparison of a number: write \"" + found->name + " > 1.5\", with <, <=, > or >="};
  }
  return StateMachine::Condition{.input = input, .is = *is, .value = *value};
}

}  // namespace throng::anim
