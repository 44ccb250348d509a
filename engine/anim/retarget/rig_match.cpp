#include "engine/anim/retarget/rig_match.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/retarget/body_pose.h"

namespace throng::anim {

namespace {

std::string plain_name(std::string_view name) {
  if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  std::string plain(name);
  std::ranges::transform(plain, plain.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return plain;
}

/// Returns the bones by plain name; -1 where several have it.
std::map<std::string, int> bones_by_name(const Skeleton& skeleton) {
  std::map<std::string, int> bones;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const std::string name = plain_name(skeleton.bones[static_cast<std::size_t>(bone)].name);
    if (name.empty()) continue;
    const auto [place, is_new] = bones.emplace(name, bone);
    if (!is_new) place->second = -1;
  }
  return bones;
}

void match_parts(RigMatch& match) {
  for (std::size_t role = 0; role < body_role_count; ++role) {
    const int from = match.from.bones[role], to = match.to.bones[role];
    if (from >= 0 && to >= 0) match.source_of[static_cast<std::size_t>(to)] = from;
  }
}

void match_names(const Skeleton& from, const Skeleton& to, RigMatch& match) {
  const std::map<std::string, int> sources = bones_by_name(from);
  for (const auto& [name, bone] : bones_by_name(to)) {
    const auto source = sources.find(name);
    if (bone < 0 || source == sources.end() || source->second < 0) continue;
    int& matched = match.source_of[static_cast<std::size_t>(bone)];
    const bool is_free = matched < 0 && std::ranges::count(match.source_of, source->second) == 0;
    if (is_free) matched = source->second;
  }
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double sum = 0.0;
  for (int column = 0; column < 4; ++column) sum += glm::distance(a[column], b[column]);
  return sum;
}

/// Compares how bones stand. Lengths count against the height of the skeleton that follows.
class RestComparison {
 public:
  RestComparison(const Skeleton& from, const Skeleton& to, const RigMatch& match, const Clip& clip)
      : from_(from), to_(to), match_(match), clip_(clip), closest_length_(closest * height_of(bind_pose(to))) {
    own_rest_ = reference_pose(to, nullptr, 0.0).globals;
    for (const double share : {0.0, 0.5, 1.0}) {
      source_poses_.push_back(reference_pose(from, &clip, std::lerp(clip.start, clip.duration, share)).globals);
    }
  }

  bool agrees() const {
    for (std::size_t b = 0; b < to_.bones.size(); ++b) {
      if (match_.source_of[b] >= 0 && !stands_alike(to_.bones[b], match_.source_of[b])) return false;
    }
    return match_.matched() > 0;
  }

 private:
  static constexpr double closest = 1e-3;  // of the height, and of a turn's half angle

  bool stands_alike(const Bone& bone, int source) const {
    const Bone& other = from_.bones[static_cast<std::size_t>(source)];
    const auto tracks = std::ranges::find(clip_.tracks, source, &BoneTracks::bone);
    const bool turns = tracks != clip_.tracks.end() && !tracks->rotation.empty();
    const StateTransform x = rest_transform(bone), y = rest_transform(other);
    return glm::distance(x.position, y.position) <= closest_length_ && glm::distance(x.scale, y.scale) <= closest &&
           (turns || std::abs(glm::dot(x.rotation, y.rotation)) >= 1.0 - closest * closest) && hangs_alike(bone, other);
  }

  /// Says whether what is above both is the same: bones that follow each other, or what stands still in the clip, such
  /// as an armature that only one file animates.
  bool hangs_alike(const Bone& bone, const Bone& other) const {
    const int parent = bone.parent < 0 ? -1 : match_.source_of[static_cast<std::size_t>(bone.parent)];
    if (parent >= 0) return parent == other.parent && difference(bone.prefix, other.prefix) <= closest_length_;
    const glm::dmat4 own = above(bone, own_rest_);
    return std::ranges::all_of(source_poses_, [&](const std::vector<glm::dmat4>& globals) {
      return difference(own, above(other, globals)) <= closest_length_;
    });
  }

  static glm::dmat4 above(const Bone& bone, const std::vector<glm::dmat4>& globals) {
    return bone.parent < 0 ? bone.prefix : globals[static_cast<std::size_t>(bone.parent)] * bone.prefix;
  }

  const Skeleton& from_;
  const Skeleton& to_;
  const RigMatch& match_;
  const Clip& clip_;
  double closest_length_ = 0.0;
  std::vector<glm::dmat4> own_rest_;
  std::vector<std::vector<glm::dmat4>> source_poses_;
};

}  // namespace

bool RigMatch::follows(int source) const { return std::ranges::count(source_of, source) > 0; }

int RigMatch::matched() const {
  return static_cast<int>(std::ranges::count_if(source_of, [](int source) { return source >= 0; }));
}

RigMatch match_rigs(const Skeleton& from, const Skeleton& to) {
  RigMatch match{.from = find_rig(from), .to = find_rig(to), .source_of = std::vector<int>(to.bones.size(), -1)};
  match_parts(match);
  match_names(from, to, match);
  return match;
}

bool keys_fit(const Skeleton& from, const Skeleton& to, const RigMatch& match, const Clip& clip) {
  return RestComparison(from, to, match, clip).agrees();
}

std::vector<std::string> lost_bones(const Skeleton& from, const RigMatch& match, const Clip& clip) {
  std::vector<bool> reaches(from.bones.size(), false);
  for (int bone = from.bone_count() - 1; bone >= 0; --bone) {
    const auto index = static_cast<std::size_t>(bone);
    reaches[index] = reaches[index] || match.follows(bone);
    if (reaches[index] && from.bones[index].parent >= 0)
      reaches[static_cast<std::size_t>(from.bones[index].parent)] = true;
  }
  std::vector<std::string> names;
  for (const BoneTracks& tracks : clip.tracks) {
    const auto bone = static_cast<std::size_t>(tracks.bone);
    if (!reaches[bone]) names.push_back(from.bones[bone].name);
  }
  return names;
}

}  // namespace throng::anim
