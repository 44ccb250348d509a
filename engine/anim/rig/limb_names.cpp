#include "engine/anim/rig/limb_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>

namespace throng::anim {

namespace {

using Words = std::vector<std::string>;

constexpr std::array helper_words{"twist",  "roll",   "ik",   "fk",       "pole",   "target", "end",  "nub",
                                  "helper", "socket", "slot", "ctrl",     "mch",    "org",    "sec",  "control",
                                  "tweak",  "jiggle", "tip",  "handslot", "muscle", "weapon", "prop", "attach"};

/// Words that may follow the part and add nothing to it.
constexpr std::array trailing_words{"joint", "jnt", "bone", "bend", "upper", "lower"};

struct PartWord {
  std::string_view word;
  BodyPart part;
};
constexpr std::array part_words{PartWord{"pelvis", BodyPart::pelvis},
                                PartWord{"hips", BodyPart::pelvis},
                                PartWord{"hip", BodyPart::pelvis},
                                PartWord{"spine", BodyPart::spine},
                                PartWord{"chest", BodyPart::spine},
                                PartWord{"torso", BodyPart::spine},
                                PartWord{"abdomen", BodyPart::spine},
                                PartWord{"waist", BodyPart::spine},
                                PartWord{"neck", BodyPart::neck},
                                PartWord{"head", BodyPart::head},
                                PartWord{"upleg", BodyPart::upper_leg},
                                PartWord{"upperleg", BodyPart::upper_leg},
                                PartWord{"legupper", BodyPart::upper_leg},
                                PartWord{"thigh", BodyPart::upper_leg},
                                PartWord{"femur", BodyPart::upper_leg},
                                PartWord{"leg", BodyPart::leg},
                                PartWord{"lowerleg", BodyPart::lower_leg},
                                PartWord{"lowleg", BodyPart::lower_leg},
                                PartWord{"leglower", BodyPart::lower_leg},
                                PartWord{"shin", BodyPart::lower_leg},
                                PartWord{"calf", BodyPart::lower_leg},
                                PartWord{"knee", BodyPart::lower_leg},
                                PartWord{"foot", BodyPart::foot},
                                PartWord{"ankle", BodyPart::foot},
                                PartWord{"toe", BodyPart::toe},
                                PartWord{"toes", BodyPart::toe},
                                PartWord{"toebase", BodyPart::toe},
                                PartWord{"ball", BodyPart::toe},
                                PartWord{"shoulder", BodyPart::shoulder},
                                PartWord{"clavicle", BodyPart::shoulder},
                                PartWord{"collar", BodyPart::shoulder},
                                PartWord{"uparm", BodyPart::upper_arm},
                                PartWord{"upperarm", BodyPart::upper_arm},
                                PartWord{"armupper", BodyPart::upper_arm},
                                PartWord{"shldr", BodyPart::upper_arm},
                                PartWord{"arm", BodyPart::arm},
                                PartWord{"forearm", BodyPart::lower_arm},
                                PartWord{"lowerarm", BodyPart::lower_arm},
                                PartWord{"lowarm", BodyPart::lower_arm},
                                PartWord{"armlower", BodyPart::lower_arm},
                                PartWord{"elbow", BodyPart::lower_arm},
                                PartWord{"hand", BodyPart::hand},
                                PartWord{"wrist", BodyPart::hand},
                                PartWord{"palm", BodyPart::hand},
                                PartWord{"fist", BodyPart::hand}};

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Says whether a word begins here: "upperArm" and "LThigh" are two words each.
bool begins_word(std::string_view name, std::size_t i) {
  if (i == 0 || !is_upper(name[i])) return false;
  return is_lower(name[i - 1]) || (is_upper(name[i - 1]) && i + 1 < name.size() && is_lower(name[i + 1]));
}

/// Splits a name into lower-case words and drops numbers.
Words words_of(std::string_view name) {
  Words words;
  bool open = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i])) {
      open = false;
      continue;
    }
    if (!open || begins_word(name, i)) words.emplace_back();
    open = true;
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return words;
}

/// Takes the words that say a side out of `words`; "leftfoot" becomes "foot".
BodySide take_side(Words& words) {
  BodySide side = BodySide::none;
  for (std::string& word : words) {
    for (const auto& [name, named_side] : {std::pair{"left", BodySide::left}, std::pair{"right", BodySide::right}}) {
      const std::string_view whole(name);
      if (!word.starts_with(whole) && word != whole.substr(0, 1)) continue;
      word.erase(0, std::min(whole.size(), word.size()));
      side = named_side;
    }
  }
  std::erase(words, std::string());
  return side;
}

template <std::size_t size>
bool is_one_of(const std::array<const char*, size>& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

BodyPart part_of(std::string_view word) {
  const auto found = std::ranges::find(part_words, word, &PartWord::word);
  return found == part_words.end() ? BodyPart::other : found->part;
}

constexpr LimbName part_of(BodyRole role) {
  constexpr std::array trunk{BodyPart::pelvis, BodyPart::spine, BodyPart::spine,
                             BodyPart::spine,  BodyPart::neck,  BodyPart::head};
  constexpr std::array limbs{BodyPart::shoulder,  BodyPart::upper_arm, BodyPart::lower_arm, BodyPart::hand,
                             BodyPart::upper_leg, BodyPart::lower_leg, BodyPart::foot,      BodyPart::toe};
  const std::size_t index = index_of(role);
  if (index < trunk.size()) return {.part = trunk[index]};
  const bool left = role < BodyRole::right_shoulder;
  return {.part = limbs[index - index_of(left ? BodyRole::left_shoulder : BodyRole::right_shoulder)],
          .side = left ? BodySide::left : BodySide::right};
}

}  // namespace

LimbName read_limb_name(std::string_view bone_name) {
  Words words = words_of(bone_name);
  LimbName name{.side = take_side(words)};
  if (std::ranges::any_of(words, [](const std::string& word) { return is_one_of(helper_words, word); })) {
    name.part = BodyPart::helper;
    return name;
  }
  for (; !words.empty() && name.part == BodyPart::other; words.pop_back()) {
    if (words.size() > 1) name.part = part_of(words[words.size() - 2] + words.back());
    if (name.part == BodyPart::other) name.part = part_of(words.back());
    if (!is_one_of(trailing_words, words.back())) break;
  }
  if (name.part == BodyPart::pelvis && name.side != BodySide::none) name.part = BodyPart::upper_leg;  // "LeftHip"
  return name;
}

std::vector<LimbName> limb_names(const Skeleton& skeleton) {
  std::vector<LimbName> names;
  std::vector<LimbName> said;
  for (const Bone& bone : skeleton.bones) {
    if (bone.role) said.push_back(part_of(*bone.role));
    names.push_back(bone.role ? said.back() : read_limb_name(bone.name));
  }
  for (std::size_t b = 0; b < names.size(); ++b) {
    const bool is_spine = names[b].part == BodyPart::spine;  // of which there are several
    if (skeleton.bones[b].role || is_spine || std::ranges::count(said, names[b]) == 0) continue;
    names[b].part = BodyPart::helper;
  }
  return names;
}

}  // namespace throng::anim
