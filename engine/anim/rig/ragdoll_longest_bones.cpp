#include <algorithm>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/ragdoll_rig.h"

namespace throng::anim {
namespace {

/// A group shorter than this share of the longest group's reach gets no body.
constexpr double tiny = 0.08;

/// Returns how far the surface of each bone goes from its origin; -1 for a bone without any at or below it.
std::vector<double> surface_reach(const Model& model) {
  const Skeleton& skeleton = model.skeleton;
  std::vector<double> reach(skeleton.bones.size(), model.meshes.empty() ? 0.0 : -1.0);
  for (const SkinnedMesh& mesh : model.meshes) {
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
      const auto bone = static_cast<std::size_t>(skeleton.palette[mesh.palette_entries[vertex][0]].bone);
      const double distance = glm::distance(glm::dvec3(mesh.positions[vertex]), skeleton.references[bone].origin);
      reach[bone] = std::max(reach[bone], distance);
    }
  }
  for (std::size_t bone = reach.size(); bone-- > 0;) {
    const int parent = skeleton.bones[bone].parent;
    if (reach[bone] < 0.0 || parent < 0) continue;
    reach[static_cast<std::size_t>(parent)] = std::max(reach[static_cast<std::size_t>(parent)], 0.0);
  }
  return reach;
}

/// Joins groups of bones step by step. The topmost bone of a group gives it its index.
class Groups {
 public:
  explicit Groups(const Model& model)
      : skeleton_(model.skeleton), alive_(model.skeleton.bones.size()), reach_(surface_reach(model)) {
    std::ranges::transform(reach_, alive_.begin(), [](double reach) { return static_cast<char>(reach >= 0.0); });
    find_top();
    for (int bone = 0; bone < skeleton_.bone_count(); ++bone) {
      if (!is_below(skeleton_, bone, top_)) alive_[at(bone)] = 0;
    }
    const bool has_surface = !model.meshes.empty();
    for (int bone = skeleton_.bone_count() - 1; bone > top_; --bone) {
      if (alive_[at(bone)] != 0) reach_along(bone, has_surface);
    }
    count_ = static_cast<int>(std::ranges::count(alive_, char{1}));
  }

  void join_until(int most) {
    while (count_ > most) join(cheapest([](int) { return true; }));
    const double longest = *std::ranges::max_element(reach_);
    const auto is_tiny = [&](int bone) { return reach_[at(bone)] < tiny * longest; };
    for (int bone = cheapest(is_tiny); bone >= 0; bone = cheapest(is_tiny)) join(bone);
  }

  std::vector<RagdollBone> chosen() const {
    std::vector<RagdollBone> bones;
    std::vector<int> entries(alive_.size(), -1);
    for (int bone = top_; bone < skeleton_.bone_count(); ++bone) {
      if (alive_[at(bone)] == 0) continue;
      entries[at(bone)] = static_cast<int>(bones.size());
      bones.push_back({.bone = bone, .parent = bone == top_ ? -1 : entries[at(group_above(bone))]});
    }
    return bones;
  }

 private:
  static std::size_t at(int bone) { return static_cast<std::size_t>(bone); }
  int parent(int bone) const { return skeleton_.parent(bone); }
  double distance(int a, int b) const {
    return glm::distance(skeleton_.references[at(a)].origin, skeleton_.references[at(b)].origin);
  }

  /// Lets a bone reach to its children. Without children and surface it reaches half as far as it is from its parent.
  void reach_along(int bone, bool has_surface) {
    const double length = distance(bone, parent(bone));
    if (!has_surface && reach_[at(bone)] == 0.0) reach_[at(bone)] = 0.5 * length;
    reach_[at(parent(bone))] = std::max(reach_[at(parent(bone))], length);
  }

  int only_child(int bone) const {
    int only = -1;
    for (int child = bone + 1; child < skeleton_.bone_count(); ++child) {
      if (alive_[at(child)] == 0 || parent(child) != bone) continue;
      if (only >= 0) return -1;
      only = child;
    }
    return only;
  }

  /// Finds the first bone that branches; bones above it only place it. A chain starts at its first bone.
  void find_top() {
    const auto first = std::ranges::find(alive_, char{1});
    top_ = first == alive_.end() ? 0 : static_cast<int>(first - alive_.begin());
    int bone = top_;
    for (int child = only_child(bone); child >= 0; child = only_child(bone)) bone = child;
    const bool branches = std::ranges::any_of(skeleton_.bones, [&](const Bone& other) { return other.parent == bone; });
    if (branches) top_ = bone;
  }

  int group_above(int bone) const {
    do bone = parent(bone);
    while (alive_[at(bone)] == 0);
    return bone;
  }

  double reach_if_joined(int bone) const {
    const int above = group_above(bone);
    return std::max(reach_[at(above)], distance(bone, above) + reach_[at(bone)]);
  }

  int cheapest(auto may_go) const {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int bone = top_ + 1; bone < skeleton_.bone_count(); ++bone) {
      if (alive_[at(bone)] == 0 || !may_go(bone) || reach_if_joined(bone) >= least) continue;
      best = bone;
      least = reach_if_joined(bone);
    }
    return best;
  }

  void join(int bone) {
    reach_[at(group_above(bone))] = reach_if_joined(bone);
    reach_[at(bone)] = 0.0;
    alive_[at(bone)] = 0;
    --count_;
  }

  const Skeleton& skeleton_;
  std::vector<char> alive_;    ///< 1: a group of its own
  std::vector<double> reach_;  ///< how far a group extends from its first origin
  int top_ = 0;
  int count_ = 0;
};

}  // namespace

std::vector<RagdollBone> choose_longest_bones(const Model& model) {
  Groups groups(model);
  groups.join_until(max_ragdoll_bodies);
  return groups.chosen();
}

}  // namespace throng::anim
