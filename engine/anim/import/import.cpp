#include "engine/anim/import/import.h"

#include <algorithm>
#include <exception>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/anim/asset/morph_limits.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/import/animations.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/carried_meshes.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/json_document.h"
#include "engine/anim/import/materials.h"
#include "engine/anim/import/memory/memory_account.h"
#include "engine/anim/import/meshes.h"
#include "engine/anim/import/node_tree.h"
#include "engine/anim/import/reach.h"
#include "engine/anim/import/skeleton_builder.h"
#include "engine/anim/import/source_file.h"
#include "engine/anim/survey/bone_importance.h"
#include "engine/base/files/input_file.h"
#include "engine/base/text/plain_text.h"

namespace throng::import {

namespace {

std::vector<int> parents_of(const anim::Skeleton& skeleton) {
  std::vector<int> parents;
  for (const anim::Bone& bone : skeleton.bones) parents.push_back(bone.parent);
  return parents;
}

anim::Model build_model(Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
                        BuiltSkeleton built) {
  MaterialCollector materials(document);
  anim::Model model;
  Surfaces surfaces = read_surfaces(document, tree, animations, built, materials);
  model.meshes = std::move(surfaces.meshes);
  model.mesh_lods = std::move(surfaces.mesh_lods);
  model.parts = std::move(surfaces.parts);
  model.morphs = std::move(surfaces.morphs);
  model.skeleton = std::move(built.skeleton);
  model.skins = std::move(built.skins);
  model.clips = std::move(built.clips);
  model.faces_backwards = document.humanoid.faces_backwards;
  model.materials = materials.take_materials();
  model.images = materials.take_images();
  add_morph_tracks(animations, model, *document.memory);
  if (std::string left_out = anim::limit_morphs(model); !left_out.empty()) document.repairs.push_back(left_out);
  anim::reorder_bones(model, anim::order_bones(parents_of(model.skeleton), anim::bone_importance(model)));
  return model;
}

std::size_t vertex_count(const anim::Model& model) {
  std::size_t count = 0;
  for (const anim::SkinnedMesh& mesh : model.meshes) count += mesh.positions.size();
  return count;
}

/// Refuses the first of the repairs.
[[noreturn]] void refuse_repairs(const std::vector<std::string>& repairs) {
  const std::size_t others = repairs.size() - 1;
  throw Refusal(repairs.front() + "; strict reading refuses that" +
                (others > 0 ? " and " + std::to_string(others) + " more" : ""));
}

anim::ImportedFile import_checked(const std::string& path, const ImportOptions& options, bool skin_of_nodes) {
  MemoryAccount memory(options.memory_limit);
  Document document = load_document({.path = path, .files = options.files, .strict = options.strict}, memory);
  document.channels = options.channels;
  const NodeTree tree = build_node_tree(document);
  std::vector<Animation> animations = read_animations(document, tree);
  std::vector<FileSkin> skins = read_skins(document, tree);
  if (skins.empty() && skin_of_nodes) skins = skin_animated_nodes(document, tree, animations);
  check_reach(document, tree, animations, skins);

  anim::ImportedFile file;
  file.file = path;
  for (const Animation& animation : animations) file.animations.push_back(animation.clip.name);
  const std::vector<std::vector<int>> groups = group_skins(skins, tree);
  const std::vector<std::vector<int>> carried = find_carried_meshes(document, tree, skins, groups);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    BuiltSkeleton skeleton = build_skeleton(document, tree, animations, skins, groups[i], carried[i]);
    file.models.push_back(build_model(document, tree, animations, std::move(skeleton)));
  }
  std::ranges::stable_sort(file.models, std::ranges::greater{}, [](const anim::Model& model) {
    return std::tuple(vertex_count(model), model.skeleton.bones.size());
  });
  if (options.strict && !document.repairs.empty()) refuse_repairs(document.repairs);
  for (const std::string& repair : document.repairs) file.repairs.push_back(plain_text(repair));
  return file;
}

/// Makes an error of one line of any names of the file.
Error error_of(const std::string& path, const std::string& reason) { return {plain_text(path + ": " + reason)}; }

Result<anim::ImportedFile> import_or_refuse(const std::string& path, const ImportOptions& options, bool skin_of_nodes) {
  try {
    return import_checked(path, options, skin_of_nodes);
  } catch (const Refusal& refusal) {
    return error_of(path, refusal.what());
  } catch (const MemoryRefusal& refusal) {
    return error_of(path, refusal.what());
  } catch (const std::bad_alloc&) {
    return error_of(path, "there is not enough memory to import it; close other programs or split the model");
  } catch (const std::exception& exception) {
    return error_of(path, std::string("it cannot be imported: ") + exception.what() + "; export the file again");
  }
}

}  // namespace

Result<anim::ImportedFile> import_file(const std::string& path, const ImportOptions& options) {
  Result<anim::ImportedFile> file = import_skins(path, options);
  if (!file || !file->models.empty()) return file;
  return error_of(path, "it holds no skin, so there is no skeleton to pose; export a rigged character");
}

Result<anim::ImportedFile> import_skins(const std::string& path, const ImportOptions& options) {
  return import_or_refuse(path, options, false);
}

Result<anim::ImportedFile> import_clips(const std::string& path, const ImportOptions& options) {
  return import_or_refuse(path, options, true);
}

bool holds_clips_alone(const std::string& path) {
  const auto file = map_file(path, "a .glb or .gltf");
  if (!file) return false;
  try {
    std::vector<std::string> repairs;
    const nlohmann::json document = parse_json(split_file(file->bytes, path).json, repairs);
    return array_of(document, "meshes").empty() && !array_of(document, "animations").empty();
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace throng::import
