#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/files/kept_file.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Another order of a character's bones, and where its levels end: `bones` are indices as the character has them now,
/// `level_counts` as in Skeleton::level_bone_counts.
using BoneLodChoice = anim::BoneOrder;

/// What files call the bones: by name, and by name#node where several have the same or none; node is the index of the
/// glTF node.
std::vector<std::string> bone_keys(const anim::Skeleton& skeleton);

/// The indices of bones by their keys. The error names the first that the skeleton does not have.
anim::Result<std::vector<int>> bones_named(std::span<const std::string> keys, const anim::Skeleton& skeleton);

/// Errors name the first bone or level that cannot be: every bone once, each after its parent; 1 to
/// anim::max_bone_levels levels, the first with all bones, each further one with fewer, none empty.
anim::Status check_bone_lod(const anim::Skeleton& skeleton, const BoneLodChoice& choice);

/// The order as it is, of a character with so many bones.
BoneLodChoice present_bone_lod(std::size_t bones, std::vector<int> level_counts);

/// `choice` with one bone moved to another place: up, and the ancestors that it passes come along before it; down, and
/// what hangs on it and is passed goes along behind it. So a valid choice stays one. Levels end where they did.
/// `parents`: of each bone of the skeleton, or -1.
BoneLodChoice with_bone_moved(std::span<const int> parents, BoneLodChoice choice, std::size_t from, std::size_t to);

/// Nanoseconds that a bone adds to the update of an agent that plays one clip in a full tile, by the cost model; bones
/// are paid for in packets of 16.
double nanoseconds_a_bone();
/// Nanoseconds of the whole update of such an agent at a level.
double nanoseconds_at_level(const anim::Skeleton& skeleton, std::size_t level);

/// MODEL.lod.json: the bones in order and how many each level keeps, as a person chose them.
///     {"version": 1, "bones": ["pelvis", "spine", ...], "level_counts": [62, 32, 22, 14]}
/// Lies where the table of roles does (kept_file.h).
class BoneLodFile {
 public:
  /// `model`: its file; empty for the built-in character.
  explicit BoneLodFile(const std::filesystem::path& model);

  /// Empty if there is no file. The error names the file, what is wrong in it and what to do.
  anim::Result<std::optional<BoneLodChoice>> read(const anim::Skeleton& skeleton) const;
  /// Written whole or not at all. Where it lies, to tell people.
  anim::Result<std::filesystem::path> write(const anim::Skeleton& skeleton) const;

 private:
  KeptFile file_;
};

}  // namespace throng::app
