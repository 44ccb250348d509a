#include "engine/anim/bake/bone_match.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "engine/anim/base/elementary.h"
#include "engine/base/text/plain_text.h"

namespace throng::anim {
namespace {

// Exporters round bind matrices. Their rounding shows less than the streams' errors.
constexpr double same_position = 1e-4;  // of the skeleton's size
constexpr double same_turn = 1e-4;      // radians
constexpr double same_number = 1e-4;    // of a number, or of 1

const Bone& bone_at(const Skeleton& skeleton, int bone) { return skeleton.bones[static_cast<std::size_t>(bone)]; }

bool are_near(double a, double b) { return std::abs(a - b) <= same_number * std::max(1.0, std::abs(a)); }

double size_of(const Skeleton& skeleton) {
  double size = 0.0;
  for (const ReferenceFrame& frame : skeleton.references) size = std::max(size, glm::length(frame.origin));
  return size;
}

bool same_frame(const ReferenceFrame& a, const ReferenceFrame& b, double size) {
  const double turn = 2.0 * arc_cosine(std::min(1.0, std::abs(glm::dot(a.rotation, b.rotation))));
  return turn <= same_turn && glm::distance(a.origin, b.origin) <= same_position * size && are_near(a.scale, b.scale);
}

bool same_matrix(const glm::dmat4& a, const glm::dmat4& b) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!are_near(a[column][row], b[column][row])) return false;
    }
  }
  return true;
}

/// Matches the bones of two skeletons by their names.
class BoneMatch {
 public:
  BoneMatch(const Skeleton& skeleton, const Skeleton& other)
      : skeleton_(skeleton), other_(other), size_(size_of(skeleton)) {}

  Result<std::vector<int>> match() {
    if (const auto fault = place_all(); fault) return differ(*fault);
    for (int bone = 0; bone < other_.bone_count(); ++bone) {
      if (const auto fault = fault_of(bone); fault) return differ(*fault);
    }
    return places_;
  }

 private:
  /// Finds the place of each bone, or says which has none.
  std::optional<std::string> place_all() {
    std::unordered_map<std::string, int> places;
    for (int bone = 0; bone < skeleton_.bone_count(); ++bone) places.emplace(bone_at(skeleton_, bone).name, bone);
    for (int bone = 0; bone < other_.bone_count(); ++bone) {
      const std::string& name = bone_at(other_, bone).name;
      // Where several bones have one name, each keeps its own index.
      const bool stays = bone < skeleton_.bone_count() && bone_at(skeleton_, bone).name == name;
      const auto found = places.find(name);
      if (!stays && found == places.end()) return in_quotes(name) + " is not in " + in_quotes(skeleton_.name);
      places_.push_back(stays ? bone : found->second);
    }
    std::vector<bool> is_taken(skeleton_.bones.size(), false);
    for (const int place : places_) is_taken[static_cast<std::size_t>(place)] = true;
    const auto missing = std::ranges::find(is_taken, false) - is_taken.begin();
    if (missing < skeleton_.bone_count()) {
      return in_quotes(bone_at(skeleton_, static_cast<int>(missing)).name) + " is not in " + in_quotes(other_.name);
    }
    if (other_.bone_count() != skeleton_.bone_count()) return "several bones of one of them have one name";
    return std::nullopt;
  }

  std::optional<std::string> fault_of(int bone) const {
    const Bone& own = bone_at(other_, bone);
    const auto place = static_cast<std::size_t>(places_[static_cast<std::size_t>(bone)]);
    const Bone& like = skeleton_.bones[place];
    const int parent = own.parent < 0 ? -1 : places_[static_cast<std::size_t>(own.parent)];
    if (like.parent != parent) return in_quotes(own.name) + " has another parent";
    const ReferenceFrame& frame = other_.references[static_cast<std::size_t>(bone)];
    const bool has_same_prefix = skeleton_.rigid || same_matrix(own.prefix, like.prefix);
    if (same_frame(frame, skeleton_.references[place], size_) && has_same_prefix) return std::nullopt;
    return in_quotes(own.name) + " has another bind pose: load both at the same scale and place, or retarget the clips";
  }

  Error differ(const std::string& how) const {
    return Error{in_quotes(other_.name) + " has not the skeleton of " + in_quotes(skeleton_.name) + ": " + how};
  }

  const Skeleton& skeleton_;
  const Skeleton& other_;
  double size_;
  std::vector<int> places_;
};

}  // namespace

Result<std::vector<int>> match_bones(const Skeleton& skeleton, const Skeleton& other) {
  if (skeleton.rigid != other.rigid) {
    const Skeleton& scaled = skeleton.rigid ? other : skeleton;
    return Error{"the clips of " + in_quotes(other.name) + " cannot join those of " + in_quotes(skeleton.name) +
                 ": the bones of " + in_quotes(scaled.name) + " scale, and the others do not"};
  }
  return BoneMatch(skeleton, other).match();
}

}  // namespace throng::anim
