#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "throng/character.h"

#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/asset/joint_list.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"

namespace throng::detail {

/// The inside of a Character: what was baked, the rigs that it looks, stands, reaches and falls with, and the surface
/// if it was asked for.
struct CharacterData {
  CharacterData(anim::Character own_baked, const anim::Model& model);

  anim::Character baked;
  anim::CharacterRigs rigs;
  std::vector<anim::JointList> skins;  // [skin of the file] empty where it is another model's
  std::vector<anim::SkinnedMesh> meshes;
  std::vector<anim::Material> materials;
  std::vector<anim::Image> images;
};

/// Makes a character of a model that stands in its place, and of what was baked from it.
Character make_character(anim::Model model, anim::Character baked, bool keep_meshes);

}  // namespace throng::detail
