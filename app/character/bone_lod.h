#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/files/kept_file.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/base/result.h"

namespace throng::app {

/// Another order of a character's bones, and the ends of its levels. `bones` are indices as the character has them now;
/// `level_counts` are as in Skeleton::level_bone_counts.
using BoneLodChoice = anim::BoneOrder;

/// Returns the names that files use for the bones: the bone's own name, or name#node where several bones share a name
/// or have none. `node` is the index of the glTF node.
std::vector<std::string> bone_keys(const anim::Skeleton& skeleton);

/// Returns the indices of bones by their keys. Errors: the skeleton does not have a key; the error names the first.
Result<std::vector<int>> bones_named(std::span<const std::string> keys, const anim::Skeleton& skeleton);

/// Checks that every bone comes once and after its parent, and that there are 1 to max_bone_levels levels: the
/// first with all bones, each further one with fewer, none empty. Errors name the first bone or level that breaks this.
Status check_bone_lod(const anim::Skeleton& skeleton, const BoneLodChoice& choice);

/// Returns the present order of a character with this many bones.
BoneLodChoice present_bone_lod(std::size_t bones, std::vector<int> level_counts);

/// Returns `choice` with one bone moved to another place. If it moves up, the ancestors that it passes come along
/// before it; if it moves down, the descendants that it passes go along behind it. So a valid choice stays valid.
/// Levels end where they did. `parents` has the parent of each bone of the skeleton, or -1.
BoneLodChoice with_bone_moved(std::span<const int> parents, BoneLodChoice choice, std::size_t from, std::size_t to);

/// Returns the nanoseconds that a bone adds to the update of an agent that plays one clip in a full tile, by the cost
/// model. Bones are paid for in packets of 16.
double nanoseconds_a_bone();
/// Returns the nanoseconds of the whole update of such an agent at a level.
double nanoseconds_at_level(const anim::Skeleton& skeleton, std::size_t level);

/// The file MODEL.lod.json: the bones in order and how many each level keeps, by a person's choice.
///     {"version": 1, "bones": ["pelvis", "spine", ...], "level_counts": [62, 32, 22, 14]}
/// It lies where the table of roles does (kept_file.h).
class BoneLodFile {
 public:
  /// `model` is the file of the model; empty for the built-in character.
  explicit BoneLodFile(const std::filesystem::path& model);

  /// Returns the choice in the file; nothing if there is no file. The error names the file, what is wrong in it and
  /// what to do.
  Result<std::optional<BoneLodChoice>> read(const anim::Skeleton& skeleton) const;
  /// Writes the file whole or not at all. Returns its path, to show to people.
  Result<std::filesystem::path> write(const anim::Skeleton& skeleton) const;

 private:
  KeptFile file_;
};

}  // namespace throng::app
