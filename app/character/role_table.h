#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/character/rig_table.h"
#include "app/character/roles.h"
#include "app/files/kept_file.h"
#include "engine/base/result.h"

namespace throng::app {

/// Puts `choices` over `clips`. Errors name the role, the clip and the names that come nearest; then nothing has
/// changed.
Status choose_clips(std::span<const RoleChoice> choices, std::span<const std::string> clip_names, RoleClips& clips);

/// Returns every role with the name of its clip, or "none".
std::vector<RoleChoice> all_choices(const RoleClips& clips, std::span<const std::string> clip_names);

/// Adds to `choices` what {"walk": "Walking_A", "cheer": "none"} says. Returns what is wrong, as the end of a sentence.
std::optional<std::string> read_role_choices(const Json& clips, std::vector<RoleChoice>& choices);
Json clips_json(std::span<const RoleChoice> choices);

/// The file MODEL.throng.json, in which a person says which clip of a model plays which role, and which bone is which
/// part of the body.
///     {"version": 1, "clips": {"walk": "Walking_A", "cheer": "none"}, "rig": {"hips": "Bone.003"}}
/// Roles and bones that it does not name are guessed from the names of clips and bones.
class RoleFile {
 public:
  /// `model` is the file of the model; empty for the built-in character.
  explicit RoleFile(const std::filesystem::path& model);

  /// Returns the choices in the file; none if there is no file. The error names the file and what is wrong in it.
  Result<std::vector<RoleChoice>> read() const;
  /// Returns the parts of the body that the file says; none if there is no file.
  Result<std::vector<RigChoice>> read_rig() const;
  /// Writes the file whole or not at all, and returns its path. The parts of the body stay as
  /// they are in it, so a file that cannot be read is not written over.
  Result<std::filesystem::path> write(std::span<const RoleChoice> choices) const;
  /// Writes the parts of the body; the clips stay as they are.
  Result<std::filesystem::path> write_rig(std::span<const RigChoice> choices) const;

 private:
  /// Returns what `read_choices(value, choices)` adds for one key of the file; nothing where there is no file or no
  /// such key.
  template <typename Choice>
  Result<std::vector<Choice>> read_key(const char* key,
                                       std::optional<std::string> (*read_choices)(const Json&,
                                                                                  std::vector<Choice>&)) const;
  Result<std::filesystem::path> write_both(std::span<const RoleChoice> clips, std::span<const RigChoice> rig) const;

  KeptFile file_;
};

}  // namespace throng::app
