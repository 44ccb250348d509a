#include "engine/anim/rig/spring_rig.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace throng::anim {
namespace {

constexpr float shortest_bone = 1e-5F;  // metres

bool is_amount(float value) { return value >= 0.0F && std::isfinite(value); }
bool is_finite_place(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool are_options(const SpringChain& chain) {
  const SpringOptions& options = chain.options;
  return is_amount(options.stiffness) && is_amount(options.damping) && is_amount(options.drag) &&
         is_amount(options.radius) && is_amount(chain.tip) && is_finite_place(options.gravity);
}

bool is_collider(const SpringCollider& collider) {
  return is_amount(collider.radius) && is_finite_place(collider.from) && is_finite_place(collider.to);
}

class RigMaker {
 public:
  explicit RigMaker(const Skeleton& skeleton) : skeleton_(skeleton), node_of_(skeleton.bones.size(), -1) {}

  Status add(const SpringChain& chain) {
    const std::string about = "the chain from '" + chain.first + "' to '" + chain.last + "'";
    if (!are_options(chain)) return error(about + " has options that are negative or not finite: mend them");
    const Result<int> first = find(chain.first);
    if (!first) return first.error();
    const Result<int> last = find(chain.last);
    if (!last) return last.error();
    std::vector<int> bones;
    for (int bone = *last; bone >= 0 && bone != *first; bone = parent(bone)) bones.push_back(bone);
    bones.push_back(*first);
    if (parent_of_chain(bones) != *first) return error(about + " does not lead down: name a bone below the first");
    std::ranges::reverse(bones);
    return add_joints(chain, bones, about);
  }

  Status add(const SpringCollider& collider) {
    if (!is_collider(collider)) {
      return error("the collider at '" + collider.bone + "' is negative or not finite: mend it");
    }
    const Result<int> bone = find(collider.bone);
    if (!bone) return bone.error();
    rig_.colliders.push_back(
        {.node = node(*bone), .from = collider.from, .to = collider.to, .radius = collider.radius});
    return Done{};
  }

  Result<SpringRig> made() {
    const auto check = [&](std::size_t count, std::size_t most, const char* what) {
      return count <= most ? std::string() : std::to_string(count) + " " + what + " of at most " + std::to_string(most);
    };
    for (const std::string& excess : {check(rig_.chains.size(), max_spring_chains, "chains"),
                                      check(rig_.joints.size(), max_spring_joints, "joints"),
                                      check(rig_.colliders.size(), max_spring_colliders, "colliders"),
                                      check(rig_.nodes.size(), max_spring_nodes, "bones to pose")}) {
      if (!excess.empty()) return error("its springs have " + excess + ": name fewer");
    }
    for (const SpringNode& node : rig_.nodes) rig_.bone_end = std::max(rig_.bone_end, node.bone + 1);
    return std::move(rig_);
  }

 private:
  Error error(const std::string& what) const { return Error{"skeleton '" + skeleton_.name + "': " + what}; }
  int parent(int bone) const { return skeleton_.parent(bone); }
  glm::dvec3 origin(int bone) const { return skeleton_.references[static_cast<std::size_t>(bone)].origin; }

  Result<int> find(const std::string& name) const {
    const auto found = std::ranges::find(skeleton_.bones, name, &Bone::name);
    if (found == skeleton_.bones.end()) return error("no bone is called '" + name + "': name one that it has");
    if (std::ranges::count(skeleton_.bones, name, &Bone::name) > 1) {
      return error("several bones are called '" + name + "': give them names of their own");
    }
    return static_cast<int>(found - skeleton_.bones.begin());
  }

  /// Returns the bone that the walk up from a chain's end stopped at.
  int parent_of_chain(const std::vector<int>& upwards) const {
    return upwards.size() < 2 ? upwards.front() : parent(upwards[upwards.size() - 2]);
  }

  /// Returns the node of a bone, made with those above it.
  int node(int bone) {
    if (bone < 0) return -1;
    int& known = node_of_[static_cast<std::size_t>(bone)];
    if (known >= 0) return known;
    const int above = parent(bone);
    const int parent_node = node(above);
    const glm::dvec3 from = above < 0 ? glm::dvec3(0.0) : origin(above);
    rig_.nodes.push_back({.bone = bone, .parent = parent_node, .offset = glm::vec3(origin(bone) - from)});
    known = static_cast<int>(rig_.nodes.size()) - 1;
    return known;
  }

  Status add_joints(const SpringChain& chain, const std::vector<int>& bones, const std::string& about) {
    SpringRig::Chain added{
        .first = static_cast<int>(rig_.joints.size()), .base = node(parent(bones.front())), .options = chain.options};
    glm::vec3 tail(0.0F);
    for (std::size_t i = 0; i < bones.size(); ++i) {
      const bool ends = i + 1 == bones.size();
      if (ends && chain.tip <= 0.0F) break;
      if (!ends) tail = glm::vec3(origin(bones[i + 1]) - origin(bones[i]));
      if (ends)
        tail = glm::length(tail) > shortest_bone ? chain.tip * glm::normalize(tail) : glm::vec3(0, -chain.tip, 0);
      if (glm::length(tail) <= shortest_bone) return error(about + " has a bone without length: leave it out");
      if (!swings_.insert(bones[i]).second) return error(about + " shares a bone with another chain: name it once");
      rig_.joints.push_back({.node = node(bones[i]), .tail = tail, .length = glm::length(tail)});
      ++added.count;
    }
    if (added.count == 0) return error(about + " has no length: name a bone below the first, or give it a tip");
    rig_.chains.push_back(added);
    return Done{};
  }

  const Skeleton& skeleton_;
  std::vector<int> node_of_;  // [bone]
  std::set<int> swings_;      // bones
  SpringRig rig_;
};

}  // namespace

Result<SpringRig> make_spring_rig(const Skeleton& skeleton, std::span<const SpringChain> chains,
                                  std::span<const SpringCollider> colliders) {
  if (chains.empty()) return Error{"skeleton '" + skeleton.name + "': no chain was named that could swing"};
  if (!skeleton.rigid) {
    return Error{"skeleton '" + skeleton.name +
                 "' scales or shears its bones, so none of them can swing: export it without scale on bones"};
  }
  RigMaker maker(skeleton);
  for (const SpringChain& chain : chains) {
    if (const Status added = maker.add(chain); !added) return added.error();
  }
  for (const SpringCollider& collider : colliders) {
    if (const Status added = maker.add(collider); !added) return added.error();
  }
  return maker.made();
}

}  // namespace throng::anim
