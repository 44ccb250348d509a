#pragma once

#include <memory>
#include <vector>

#include "throng/character.h"

#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/asset/joint_list.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"

namespace throng::detail {

/// Holds the rigs with which a character looks, stands, reaches and falls, and its surface if that was asked for.
/// Characters that differ in their clips alone share it.
struct CharacterBody {
  explicit CharacterBody(const anim::Model& model);

  anim::CharacterRigs rigs;
  std::vector<anim::JointList> skins;  // [skin of the file] empty where it is another model's
  std::vector<anim::SkinnedMesh> meshes;
  std::vector<anim::Material> materials;
  std::vector<anim::Image> images;
};

/// The inside of a Character. Neither part is null.
struct CharacterData {
  std::shared_ptr<const anim::Character> baked;
  std::shared_ptr<const CharacterBody> body;
};

/// Makes a character of a model that stands in its place, and of the model's baked data.
Character make_character(anim::Model model, anim::Character baked, bool keep_meshes);

}  // namespace throng::detail
