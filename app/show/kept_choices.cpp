#include "app/show/kept_choices.h"

#include "app/character/bone_lod.h"
#include "app/character/role_table.h"
#include "app/character/skin_choice.h"
#include "app/show/lod/lod_export.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"

namespace throng::app {

Result<std::filesystem::path> save_roles(const CharacterSource& character) {
  return RoleFile(character.file).write(all_choices(character.roles.clips, character.clip_names));
}

// It counts for every character of the file, as it is read with the file.
Result<std::filesystem::path> save_rig(const CharacterSource& character) {
  return RoleFile(character_file(character.file).path).write_rig(character.rig);
}

Result<std::filesystem::path> save_bone_lod(const CharacterSource& character) {
  return BoneLodFile(character.file).write(character.character->skeleton);
}

namespace {

// Returns the limit that a person set, since equal values must export equal files and the tolerance follows measures of
// each frame. Where a budget decides, no person set a limit, and it returns the tolerance.
float exported_tolerance(const Stage& stage) {
  const anim::LodFigures& figures = stage.posed().level_of_detail().figures();
  const bool budget_decides =
      figures.binding == anim::BindingLimit::budget || figures.binding == anim::BindingLimit::both_miss;
  const float limit = pose_error_limit(stage.tuning().error_px > 0.0F ? stage.tuning() : Tuning());
  const bool has_limit = stage.tuning().error_px > 0.0F && !budget_decides;
  return has_limit || figures.tolerance_px <= 0.0F ? limit : figures.tolerance_px;
}

}  // namespace

Result<std::filesystem::path> export_lod(const Show& show, std::size_t index) {
  const CharacterSource& character = show.stage().characters()[index];
  const LodInForce in_force{
      .tuning = show.stage().tuning(),
      .character = lod_character(character),
      .tolerance_pixels = exported_tolerance(show.stage()),
      .pixels_per_unit = render::pixels_tall(show.view().camera, static_cast<float>(show.view().height), 1.0F, 1.0F)};
  return KeptFile(character.file, ".lod.export.json", "The level of detail")
      .write(lod_as_json(character, lod_levels(character), show.painter().mesh_levels(index), in_force));
}

}  // namespace throng::app
