#include "engine/anim/bake/clip_roles.h"

#include <algorithm>
#include <cctype>
#include <limits>

namespace throng::anim {
namespace {

using Role = ClipRole;

bool any_begins_with_one_of(const ClipWords& words, std::span<const std::string_view> beginnings) {
  return std::ranges::any_of(beginnings, [&](auto word) { return any_begins_with(words, word); });
}

struct RoleWords {
  Role role;
  std::vector<std::string_view> wanted;    // best first
  std::vector<std::string_view> unwanted;  // a name with such a word is another thing
  std::vector<std::string_view> also{};    // a name without any of these words is another thing, too
};

const std::vector<std::string_view> not_straight_ahead{"back",   "bwd",  "left", "right",
                                                       "strafe", "jump", "stop", "start"};
const std::vector<std::string_view> not_a_steady_step{"jump", "stop",  "start", "turn",   "crouch", "dodge", "roll",
                                                      "dash", "climb", "stair", "attack", "hit",    "up",    "down"};

std::vector<std::string_view> not_steady_nor(std::vector<std::string_view> others) {
  others.insert(others.end(), not_a_steady_step.begin(), not_a_steady_step.end());
  return others;
}

const std::vector<RoleWords>& vocabulary() {
  static const std::vector<RoleWords> words{
      {Role::stand,
       {"idle", "survey", "breath", "stand"},
       {"jump", "lie", "sit", "fall", "swim", "crouch", "up", "down"}},
      {Role::look_around, {"look", "survey", "search"}, {}},
      {Role::walk, {"walk", "jog", "run", "move"}, not_straight_ahead},
      {Role::jog, {"jog", "trot"}, not_straight_ahead},
      {Role::run, {"run", "sprint", "gallop"}, not_straight_ahead},
      {Role::wave, {"wav", "greet", "hello"}, {}},
      {Role::cheer,
       {"cheer", "celebrat", "victor", "danc", "excited", "happy", "thumbs", "jump"},
       {"idle", "land", "start", "end", "attack", "walk", "run"}},
      {Role::clap, {"clap", "applau"}, {}},
      {Role::sit, {"sit", "seat"}, {"down", "up", "pose", "stand", "start", "stop"}},
      {Role::walk_back,
       {"walk", "step", "move", "strafe", "jog", "run"},
       not_steady_nor({"left", "right", "l", "r"}),
       {"back", "bwd"}},
      {Role::step_left,
       {"step", "strafe", "walk", "move", "jog", "run"},
       not_steady_nor({"right", "r", "back", "bwd", "forward", "fwd"}),
       {"left", "l"}},
      {Role::step_right,
       {"step", "strafe", "walk", "move", "jog", "run"},
       not_steady_nor({"left", "l", "back", "bwd", "forward", "fwd"}),
       {"right", "r"}},
      {Role::shuffle,
       {"shuffl", "slow"},
       not_steady_nor({"back", "bwd", "left", "right", "strafe", "jog", "run", "danc"}),
       {"shuffl", "walk"}},
      {Role::step_in_place,
       {"march", "step", "trampl", "mark"},
       not_steady_nor({"left", "right"}),
       {"place", "spot", "time"}},
      {Role::veer_left,
       {"veer", "diag", "forward", "fwd"},
       not_steady_nor({"right", "r", "back", "bwd"}),
       {"left", "l"}},
      {Role::veer_right,
       {"veer", "diag", "forward", "fwd"},
       not_steady_nor({"left", "l", "back", "bwd"}),
       {"right", "r"}},
      {Role::talk, {"talk", "speak", "convers", "chat"}, {"sit", "walk", "run", "phone"}},
      {Role::phone, {"phone", "texting"}, {"hold", "talk", "call", "walk", "run", "sit"}},
      {Role::call, {"call", "phone"}, {"walk", "run", "sit"}, {"call", "talk"}},
      {Role::drink, {"drink", "sip"}, {"walk", "run", "sit"}},
      {Role::take_picture, {"picture", "photo"}, {"walk", "run", "sit"}},
      {Role::lean, {"lean"}, {"start", "stop", "walk", "run", "left", "right"}},
      {Role::sit_on_step, {"sit"}, {"down", "up", "pose", "stand", "start", "stop"}, {"step", "stair", "ground"}},
      {Role::carry, {"carry"}, {"walk", "run", "jump"}},
      {Role::hold_up, {"hold"}, {"walk", "run"}, {"up", "umbrella"}},
      {Role::hold_phone, {"hold"}, {"walk", "run"}, {"phone"}},
      {Role::lead, {"lead"}, {"walk", "run"}},
      {Role::led, {"led"}, {}},
      {Role::push, {"push"}, {"up", "down", "pushed", "attack", "button"}},
      {Role::stick, {"stick", "cane"}, {"attack", "fight", "hit"}},
  };
  return words;
}

constexpr std::size_t another_thing = std::numeric_limits<std::size_t>::max();

// Lower is plainer: first the word itself, then as few others beside it as possible ("Idle" before "Idle_Gun").
std::size_t strangeness(const ClipWords& words, const RoleWords& role) {
  if (any_begins_with_one_of(words, role.unwanted)) return another_thing;
  if (!role.also.empty() && !any_begins_with_one_of(words, role.also)) return another_thing;
  for (std::size_t rank = 0; rank < role.wanted.size(); ++rank) {
    if (!any_begins_with(words, role.wanted[rank])) continue;
    const auto long_words = std::ranges::count_if(words, [](const auto& word) { return word.size() > 1; });
    return rank * 100 + static_cast<std::size_t>(long_words);
  }
  return another_thing;
}

int plainest(std::span<const ClipWords> names, const RoleWords& role) {
  const auto strange = [&](const ClipWords& words) { return strangeness(words, role); };
  const auto best = std::ranges::min_element(names, {}, strange);
  return best == names.end() || strange(*best) == another_thing ? no_clip : static_cast<int>(best - names.begin());
}

}  // namespace

std::optional<ClipRole> role_named(std::string_view name) {
  const auto* const found = std::ranges::find(clip_role_names, name);
  if (found == clip_role_names.end()) return std::nullopt;
  return static_cast<ClipRole>(found - clip_role_names.begin());
}

ClipWords words_of_clip(std::string_view name) {
  if (const auto bar = name.rfind('|'); bar != std::string_view::npos) name.remove_prefix(bar + 1);
  ClipWords words;
  bool inside = false, was_lower = false;
  for (const char letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isalpha(code) == 0) {
      inside = was_lower = false;
      continue;
    }
    const bool upper = std::isupper(code) != 0;
    if (!inside || (upper && was_lower)) words.emplace_back();
    words.back().push_back(static_cast<char>(std::tolower(code)));
    inside = true;
    was_lower = !upper;
  }
  return words;
}

bool any_begins_with(const ClipWords& words, std::string_view beginning) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return beginning.size() == 1 ? word == beginning : word.starts_with(beginning);
  });
}

RoleClips roles_of_clips(std::span<const std::string> clip_names) {
  std::vector<ClipWords> names;
  names.reserve(clip_names.size());
  for (const std::string& name : clip_names) names.push_back(words_of_clip(name));

  RoleClips clips{};
  const auto clip_of = [&clips](Role role) -> int& { return clips[static_cast<std::size_t>(role)]; };
  for (const RoleWords& role : vocabulary()) clip_of(role.role) = plainest(names, role);
  for (const Role gait : {Role::jog, Role::run, Role::shuffle}) {  // a clip that stands in for a walk is no other gait
    if (clip_of(gait) == clip_of(Role::walk)) clip_of(gait) = no_clip;
  }
  return clips;
}

}  // namespace throng::anim
