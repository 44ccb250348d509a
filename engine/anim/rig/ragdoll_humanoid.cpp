#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "engine/anim/rig/ragdoll_bones.h"

namespace throng::anim {
namespace {

/// A bone's name without its scheme: "mixamorig:LeftUpLeg", "DEF-upleg.L.001" and "upleg_l" are all {"upleg", 1}.
struct PlainName {
  std::string word;
  int side = 0;
};

std::vector<std::string> name_words(std::string_view name) {
  std::vector<std::string> words;
  char before = ' ';
  for (const char letter : name) {
    const auto is = [&](int (*kind)(int), char c) { return kind(static_cast<unsigned char>(c)) != 0; };
    if (is(std::isalpha, letter)) {
      const bool starts = !is(std::isalpha, before) || (is(std::isupper, letter) && is(std::islower, before));
      if (starts) words.emplace_back();
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    before = letter;
  }
  return words;
}

PlainName plain_name(std::string_view name) {
  static constexpr std::array<std::string_view, 9> schemes{"mixamorig", "def",   "b", "bip", "j",
                                                           "valve",     "biped", "c", "bone"};
  PlainName plain;
  for (const std::string& word : name_words(name)) {
    if (word == "l" || word == "left") {
      plain.side = 1;
    } else if (word == "r" || word == "right") {
      plain.side = -1;
    } else if (std::ranges::find(schemes, word) == schemes.end()) {
      plain.word += word;
    }
  }
  return plain;
}

struct PartNames {
  RagdollPart part;
  std::vector<std::string_view> words;
};

const std::vector<PartNames>& limb_names() {
  static const std::vector<PartNames> names{
      {RagdollPart::upper_arm, {"upperarm", "uparm", "arm"}},
      {RagdollPart::forearm, {"forearm", "lowerarm", "lowarm"}},
      {RagdollPart::hand, {"hand", "wrist", "palm", "fist"}},
      {RagdollPart::thigh, {"thigh", "upperleg", "upleg"}},
      {RagdollPart::shin, {"shin", "calf", "lowerleg", "lowleg", "leg"}},
      {RagdollPart::foot, {"foot", "ankle"}},
  };
  return names;
}

class Humanoid {
 public:
  explicit Humanoid(const Skeleton& skeleton) : skeleton_(skeleton) {
    for (const Bone& bone : skeleton.bones) names_.push_back(plain_name(bone.name));
  }

  std::vector<RagdollBone> choose() {
    const int pelvis = common_ancestor(find(RagdollPart::thigh, 1), find(RagdollPart::thigh, -1));
    const int chest = common_ancestor(find(RagdollPart::upper_arm, 1), find(RagdollPart::upper_arm, -1));
    if (pelvis < 0 || chest < 0 || (pelvis != chest && !is_below(chest, pelvis))) return {};
    add(pelvis, -1, RagdollPart::pelvis, 0);
    const int top = add_trunk(pelvis, chest);
    for (const int side : {1, -1}) {
      const bool whole = add_limb(top, side, {RagdollPart::upper_arm, RagdollPart::forearm, RagdollPart::hand}) &&
                         add_limb(0, side, {RagdollPart::thigh, RagdollPart::shin, RagdollPart::foot});
      if (!whole) return {};
    }
    if (!follows_the_skeleton()) return {};
    return std::move(chosen_);
  }

 private:
  int parent(int bone) const { return skeleton_.bones[static_cast<std::size_t>(bone)].parent; }

  bool is_below(int bone, int ancestor) const {
    while (bone > ancestor) bone = parent(bone);
    return bone == ancestor;
  }

  int first_named(int side, const std::vector<std::string_view>& words) const {
    const auto named = [&](const PlainName& name) {
      return name.side == side && std::ranges::find(words, name.word) != words.end();
    };
    const auto found = std::ranges::find_if(names_, named);
    return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
  }

  int find(RagdollPart part, int side) const {
    return first_named(side, std::ranges::find(limb_names(), part, &PartNames::part)->words);
  }

  /// Returns the lowest bone above both, or -1.
  int common_ancestor(int left, int right) const {
    if (left < 0 || right < 0) return -1;
    int ancestor = parent(left);
    while (ancestor >= 0 && !is_below(right, ancestor)) ancestor = parent(ancestor);
    return ancestor;
  }

  int add(int bone, int hangs_on, RagdollPart part, int side) {
    chosen_.push_back({.bone = bone, .parent = hangs_on, .part = part, .side = side});
    return static_cast<int>(chosen_.size()) - 1;
  }

  /// Adds the trunk above the pelvis, which is there already. Returns the entry that carries the arms.
  int add_trunk(int pelvis, int chest) {
    std::vector<int> between;
    for (int bone = chest; bone != pelvis; bone = parent(bone)) between.push_back(bone);
    int top = 0;
    if (between.size() > 1) top = add(between[(between.size() + 1) / 2], top, RagdollPart::spine, 0);
    if (!between.empty()) top = add(chest, top, RagdollPart::chest, 0);
    const int head = first_named(0, {"head"});
    if (head >= 0 && is_below(head, chest)) add(head, top, RagdollPart::head, 0);
    return top;
  }

  /// Adds a limb. Returns false if the first two of its three parts are missing or not below one another. The third may
  /// be missing, or lie elsewhere in the skeleton, because some rigs move feet by themselves.
  bool add_limb(int hangs_on, int side, std::array<RagdollPart, 3> parts) {
    const int upper = find(parts[0], side);
    const int lower = find(parts[1], side);
    if (upper < 0 || lower < 0 || upper == lower || !is_below(lower, upper)) return false;
    const int upper_entry = add(upper, hangs_on, parts[0], side);
    const int lower_entry = add(lower, upper_entry, parts[1], side);
    const int end = find(parts[2], side);
    if (end >= 0) add(end, lower_entry, parts[2], side);
    return true;
  }

  /// Says whether no entry stands below a later one. Names alone could put a foot under the other thigh.
  bool follows_the_skeleton() const {
    for (std::size_t low = 0; low < chosen_.size(); ++low) {
      for (std::size_t high = low + 1; high < chosen_.size(); ++high) {
        if (is_below(chosen_[low].bone, chosen_[high].bone)) return false;
      }
    }
    return true;
  }

  const Skeleton& skeleton_;
  std::vector<PlainName> names_;
  std::vector<RagdollBone> chosen_;
};

}  // namespace

std::vector<RagdollBone> choose_humanoid_bones(const Skeleton& skeleton) { return Humanoid(skeleton).choose(); }

}  // namespace throng::anim
