#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "throng/character.h"

#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/rig/ragdoll_rig.h"

namespace throng::detail {

/// Holds the rigs with which a character looks, stands, reaches and falls, and its model, without a skeleton and clips.
/// The model has a surface if that was asked for. Characters that differ in their clips alone share the body.
struct CharacterBody {
  /// `ragdoll` is empty where it is to be built of the model.
  CharacterBody(anim::Model from, std::optional<anim::RagdollRig> ragdoll, bool keep_meshes);

  anim::CharacterRigs rigs;
  std::vector<std::string> morph_names;  // [morph]
  anim::Model model;
};

/// The inside of a Character. Neither part is null.
struct CharacterData {
  std::shared_ptr<const anim::Character> baked;
  std::shared_ptr<const CharacterBody> body;
};

/// Makes a character of baked data and a body.
Character character_of(anim::Character baked, std::shared_ptr<const CharacterBody> body);

/// Checks the options of a model that is named `name`.
Status check_options(const std::string& name, const LoadOptions& options);

/// Bakes a model that stands in its place. Clips that lack the key that closes them get it if the options say so.
anim::Character bake(anim::Model& model, const LoadOptions& options);

/// Adds a character as the options ask, and the notes on it. The model stands in its place, and `baked` is of it.
/// `ragdoll` is empty where it is to be built of the model.
void add_character(anim::Model model, std::optional<anim::RagdollRig> ragdoll, anim::Character baked,
                   const LoadOptions& options, LoadedFile& into);

}  // namespace throng::detail
