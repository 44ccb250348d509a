#include "app/show/request/cast_options.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <vector>

#include "app/character/role_table.h"
#include "app/settings/choices.h"
#include "app/settings/option_values.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

bool is_plain_letter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string_view("_./,=+-:@%").find(letter) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain_letter)) return word;
  std::string in_quotes = "'";
  for (const char letter : word) in_quotes += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return in_quotes + "'";
}

void add_models(std::span<const CharacterSource> people, std::vector<std::string>& words) {
  if (people.front().file.empty()) return;
  std::vector<std::string> cast;
  for (const CharacterSource& person : people) {
    cast.push_back(person.file + (person.roles.share == 1.0 ? "" : "*" + shortest_text(person.roles.share)));
  }
  if (std::ranges::equal(people, cast, {}, &CharacterSource::file)) {
    for (const std::string& file : cast) words.push_back(quoted(file));
  } else {
    words.insert(words.end(), {"--cast", quoted(joined(cast, ","))});
  }
}

// These options hold for all characters, so they are left out where characters differ.
void add_what_all_share(std::span<const CharacterSource> people, std::vector<std::string>& words) {
  const CharacterSource& first = people.front();
  const auto is_as_first = [&](const CharacterSource& person) {
    return person.clip_files == first.clip_files && person.placement.choice == first.placement.choice;
  };
  if (!std::ranges::all_of(people, is_as_first)) return;
  if (!first.clip_files.empty()) words.insert(words.end(), {"--clips-from", quoted(joined(first.clip_files, ","))});
  const anim::PlacementChoice& asked = first.placement.choice;
  if (asked.scale) words.insert(words.end(), {"--scale", shortest_text(*asked.scale)});
  if (asked.up != anim::PlacementChoice().up) {
    words.insert(words.end(), {"--up", up_axis_words.at(static_cast<std::size_t>(asked.up))});
  }
  if (asked.ground != anim::PlacementChoice().ground) {
    words.insert(words.end(), {"--ground", ground_words.at(static_cast<std::size_t>(asked.ground))});
  }
}

void add_roles(const CharacterSource& person, std::vector<std::string>& words) {
  const auto now = all_choices(person.roles.clips, person.clip_names);
  const auto suggested = all_choices(person.suggested, person.clip_names);
  std::vector<std::string> changed;
  for (std::size_t role = 0; role < now.size(); ++role) {
    if (now[role] != suggested[role]) changed.push_back(std::string(role_names.at(role)) + "=" + now[role].clip);
  }
  if (!changed.empty()) words.insert(words.end(), {"--clips", quoted(joined(changed, ","))});
}

}  // namespace

std::string cast_options(std::span<const CharacterSource> people) {
  std::vector<std::string> words;
  add_models(people, words);
  add_what_all_share(people, words);
  if (people.size() == 1) add_roles(people.front(), words);
  return joined(words, " ", " ");
}

}  // namespace throng::app
