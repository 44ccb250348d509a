#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "throng/render/crowd_mesh_data.h"

#include "app/character/bone_lod.h"
#include "app/character/clip_files.h"
#include "app/character/load_options.h"
#include "app/character/rig_choice.h"
#include "app/character/roles.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/base/result.h"

namespace throng::app {

/// A surface that a pack holds ready for drawing; empty where the model has to be built into one.
struct PackedSurface {
  std::span<const std::byte> bytes;
  std::shared_ptr<const void> lender = {};  ///< keeps the bytes
};

/// A character as the demo needs it: the imported model, its baked clips, and the clip that is played for each role.
struct CharacterSource {
  std::string name;   ///< shown to people
  std::string file;   ///< the file that it is from; empty: the built-in character
  anim::Model model;  ///< has the surface that drawing reads, and the parts of clips that anim::reorder_character reads
  anim::GuessedPlacement placement;  ///< the size and place that it was given
  std::shared_ptr<const anim::Character> character;
  PackedSurface surface;
  std::vector<std::string> clip_names;  ///< in the character's order
  CharacterRoles roles;
  RoleClips suggested;                       ///< the roles' clips, as their names suggest
  std::array<Passage, 2> passages;           ///< into the suggested seat and out of it
  std::vector<std::string> repairs;          ///< of its file, a sentence each
  std::vector<std::string> notes;            ///< anim::ImportedFile::notes
  std::string cast_rules;                    ///< the file of rules for clothes; empty: there is none
  std::optional<std::string> rules = {};     ///< its rules, or what a person tuned, as JSON; empty: no agent dresses.
                                             ///< Nothing: the file was not read yet
  bool rules_are_chosen = false;             ///< a person chose or tuned them, so crowd files keep them
  bool order_is_chosen = false;              ///< a person chose the order of its bones since it was loaded
  std::vector<std::string> cast;             ///< names of all characters of its file
  std::size_t cast_index = 0;                ///< of this character among them
  std::vector<std::string> clip_files = {};  ///< other files whose clips it plays too
  std::vector<RigChoice> parts_in_file;      ///< the parts of the body that its file says
  std::vector<RigChoice> rig;                ///< the parts that a person says, which win

  bool has_surface() const { return !model.meshes.empty(); }
};

/// Gives the bones of the model in `path` the parts of the body that a person chose for it, and returns these parts;
/// none if nothing was chosen. The error names the file and the wrong part.
Result<std::vector<RigChoice>> take_kept_rig(const std::string& path, anim::Skeleton& skeleton);

/// Takes the roles that a person kept for the character, where there are any. The error names the file or the
/// character, and the role that cannot be.
Status take_kept_roles(CharacterSource& character);

/// Finds the clips that the roles play, once the character is there.
void guess_roles(CharacterSource& source);

/// Imports a model of `file`, "FILE" or "FILE#SKIN" (skin_choice.h), adds the clips of other files (clip_files.h),
/// gives it size and place, and bakes it; or takes it out of a pack (packed.h). `kept` has the order of its bones that
/// a person chose; with it, the parts of the body that a person kept for the file count too.
Result<CharacterSource> load_character(const std::string& file, const std::string& name,
                                       const BoneLodFile* kept = nullptr, const LoadOptions& options = {});

/// Says how a model becomes a character.
struct CharacterMaking {
  std::string path, name;
  const BoneLodFile* kept = nullptr;
  anim::PlacementChoice placement = {};
  std::span<const ClipFile* const> clips = {};
  LoadProgress progress = {};  ///< of this character
};
/// Makes a character of one of the models of a file that was read, which it takes out of the file.
Result<CharacterSource> make_character(anim::ImportedFile& file, std::size_t model, const CharacterMaking& how);

/// Brings a character into an order that check_bone_lod() let pass, without baking its clips again.
void take_order(CharacterSource& source, const BoneLodChoice& choice);

/// Plays `clips` for the roles, and measures the velocities of the gaits among them.
void assign_roles(CharacterSource& source, const RoleClips& clips);

/// Builds its surface as drawing copies it to a device, where it has none; which takes a moment.
void build_surface(CharacterSource& source);

/// Returns the surface as drawing takes it. Its spans point into `source`, which must outlive the call that uses them.
render::CrowdMeshData mesh_data(const CharacterSource& source);

}  // namespace throng::app
