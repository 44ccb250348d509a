#include "app/character/source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "app/character/body_parts.h"
#include "app/character/drawn_import.h"
#include "app/character/packed.h"
#include "app/character/role_table.h"
#include "app/character/skin_choice.h"
#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/pack/pack.h"
#include "engine/anim/survey/lod_survey.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"
#include "engine/crowd/surface_data.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app {
namespace {

constexpr std::size_t most_measured_poses = 48;  // of mesh LODs
constexpr double least_gain = 1.15;              // of a gait over the one before it, to be worth a change

// Returns the clips for which is_so() is true, or all clips where there are none.
template <typename IsSo>
std::vector<int> preferably(const anim::Character& character, const std::vector<int>& clips, IsSo is_so) {
  std::vector<int> chosen;
  const auto is_chosen = [&](int clip) { return is_so(character.clips[static_cast<std::size_t>(clip)]); };
  std::ranges::copy_if(clips, std::back_inserter(chosen), is_chosen);
  return chosen.empty() ? clips : chosen;
}

// A person of about the usual size has size 1 exactly, so that rounding in a measured height changes no picture.
float size_of_body(const CharacterRoles& roles) {
  constexpr double least_difference = 0.02;
  return std::abs(roles.size() - 1.0) < least_difference ? 1.0F : static_cast<float>(roles.size());
}

// A file may keep its bind pose as a clip. Clips that end where they began can repeat in place.
std::vector<int> to_be_repeated(const anim::Character& character, const std::vector<int>& clips) {
  const auto moves = [](const anim::BakedClip& clip) {
    return clip.keyframe() != nullptr ? clip.keyframe()->track_count > 0 : clip.sampled()->row_count > 1;
  };
  const auto loops = [](const anim::BakedClip& clip) { return clip.loops; };
  return preferably(character, preferably(character, clips, moves), loops);
}

double gait_speed(const CharacterSource& source, Role gait) {
  const int clip = source.roles.clip(gait);
  return clip == no_clip ? 0.0 : source.character->clips[static_cast<std::size_t>(clip)].ground_speed();
}

// A clip that goes another way than its role says does not count as that gait.
glm::dvec2 gait_velocity(const CharacterSource& source, Role gait) {
  constexpr double same_way = 0.7;  // the cosine of 45 degrees
  const int clip = source.roles.clip(gait);
  if (clip == no_clip) return glm::dvec2(0.0);
  const glm::dvec2 velocity = source.character->clips[static_cast<std::size_t>(clip)].ground_velocity;
  const glm::dvec2 way = way_of(gait);
  return glm::dot(velocity, way) > same_way * glm::length(velocity) ? velocity : glm::dvec2(0.0);
}

// Returns the rest pose, and some poses of all clips.
render::PosedPalettes posed_palettes(const anim::Model& model) {
  render::PosedPalettes palettes;
  const std::vector<glm::dmat4> rest = anim::reference_pose(model.skeleton, nullptr, 0.0).palette;
  palettes.emplace_back(rest.begin(), rest.end());
  if (model.clips.empty()) return palettes;
  anim::visit_surveyed_poses(
      model, [&](std::span<const glm::dmat4> palette) { palettes.emplace_back(palette.begin(), palette.end()); });
  const std::size_t stride = palettes.size() / most_measured_poses + 1;
  for (std::size_t i = 1; stride > 1 && i * stride < palettes.size(); ++i)
    palettes[i] = std::move(palettes[i * stride]);
  palettes.resize((palettes.size() + stride - 1) / stride);
  return palettes;
}

anim::ImportedFile with_model_of(anim::ImportedFile& file, std::size_t model) {
  anim::ImportedFile one{
      .file = file.file, .models = {}, .animations = file.animations, .repairs = file.repairs, .notes = file.notes};
  one.models.push_back(std::move(file.models[model]));
  return one;
}

std::shared_ptr<const anim::Character> bake(const CharacterSource& source, const LoadProgress& progress) {
  anim::BakeOptions options;
  if (progress) {
    options.progress = [&, file = std::filesystem::path(source.name).filename().string()](std::size_t done,
                                                                                          std::size_t clips) {
      progress(static_cast<double>(done) / static_cast<double>(clips),
               file + ", " + std::to_string(done) + " of " + counted(clips, "clip"));
    };
  }
  return std::make_shared<const anim::Character>(anim::bake_character(source.model, options));
}

}  // namespace

Result<std::vector<RigChoice>> take_kept_rig(const std::string& path, anim::Skeleton& skeleton) {
  auto kept = RoleFile(path).read_rig();
  if (!kept) return kept.error();
  const Status chosen = choose_bones(*kept, skeleton);
  if (chosen) return kept;
  return Error{"the rig kept for " + plain_text(path) + ": " + chosen.error().message};
}

Status take_kept_roles(CharacterSource& character) {
  const auto kept = RoleFile(character.file).read();
  if (!kept) return kept.error();
  RoleClips clips = character.roles.clips;
  if (const auto chosen = choose_clips(*kept, character.clip_names, clips); !chosen) {
    return Error{"the roles kept for " + character.name + ": " + chosen.error().message};
  }
  assign_roles(character, clips);
  return Done{};
}

void guess_roles(CharacterSource& source) {
  for (const anim::BakedClip& clip : source.character->clips) source.clip_names.push_back(clip.name);
  source.roles = roles_by_name(source.clip_names);
  source.roles.others = to_be_repeated(*source.character, source.roles.others);
  source.roles.height = source.character->bounds.height;
  source.roles.radius = source.character->bounds.body_radius;
  source.roles.is_painted = std::ranges::all_of(source.model.meshes, std::ranges::empty, &anim::SkinnedMesh::regions);
  source.suggested = source.roles.clips;
  source.passages = {source.roles.sit_down, source.roles.stand_up};
  for (Passage& passage : source.passages) {
    if (passage.clip == no_clip) continue;
    passage.seconds = to_seconds(source.character->clips[static_cast<std::size_t>(passage.clip)].duration);
  }
  assign_roles(source, source.suggested);
}

Result<CharacterSource> make_character(anim::ImportedFile& file, std::size_t model, const CharacterMaking& how) {
  anim::ImportedFile one = with_model_of(file, model);
  anim::face_forward(one);
  CharacterSource source;
  source.parts_in_file = said_parts(one.models.front().skeleton);
  if (how.kept != nullptr) {
    auto taken = take_kept_rig(how.path, one.models.front().skeleton);
    if (!taken) return taken.error();
    source.rig = std::move(*taken);
  }
  auto added = add_clips_from(how.clips, one, 0);
  if (!added) return added.error();
  source.name = plain_text(how.name);
  source.clip_files = std::move(*added);
  source.model = std::move(one.models.front());
  source.placement = anim::guess_placement(source.model, how.placement, anim::SizeRule::among_people);
  anim::place_model(source.model, source.placement.placement);
  if (how.kept != nullptr) {
    const auto choice = how.kept->read(source.model.skeleton);
    if (!choice) return choice.error();
    if (*choice) anim::reorder_bones(source.model, **choice);
  }
  source.character = bake(source, how.progress);
  anim::keep_surveyed_keys(source.model);
  guess_roles(source);
  source.repairs = std::move(one.repairs);
  source.notes = std::move(one.notes);
  return source;
}

Result<CharacterSource> load_character(const std::string& file, const std::string& name, const BoneLodFile* kept,
                                       const LoadOptions& options) {
  const CharacterFile wanted = character_file(file);
  if (pack::is_pack(wanted.path)) {
    const auto pack = pack::Pack::open(wanted.path, pack::PackBytes::copied);
    if (!pack) return pack.error();
    return take_packed(*pack, wanted, name, kept, options);
  }
  Result<anim::ImportedFile> imported = import_to_draw(wanted.path, options.import);
  if (!imported) return imported.error();
  const auto chosen = choose_model(*imported, wanted.skin);
  if (!chosen) return chosen.error();
  const auto clips = read_clip_files(options.clips_from, options.import);
  if (!clips) return clips.error();
  const std::vector<std::string> names = character_names(*imported);
  const std::vector<const ClipFile*> pointers = pointers_to(*clips);
  const CharacterMaking how{.path = wanted.path,
                            .name = name,
                            .kept = kept,
                            .placement = options.placement,
                            .clips = pointers,
                            .progress = options.progress};
  auto source = make_character(*imported, *chosen, how);
  if (!source) return source.error();
  source->cast = names;
  source->cast_index = *chosen;
  return source;
}

void take_order(CharacterSource& source, const BoneLodChoice& choice) {
  anim::reorder_bones(source.model, choice);
  source.character =
      std::make_shared<const anim::Character>(anim::reorder_character(*source.character, source.model, choice));
  source.surface = {};  // its vertices read the palette in the former order
}

void assign_roles(CharacterSource& source, const RoleClips& clips) {
  CharacterRoles& roles = source.roles;
  roles.clips = clips;
  const bool as_suggested =
      roles.clip(Role::sit) == source.suggested[index_of(Role::sit)];  // with another seat, clips fade
  roles.sit_down = as_suggested ? source.passages[0] : Passage{};
  roles.stand_up = as_suggested ? source.passages[1] : Passage{};
  roles.turns.clear();
  for (const anim::BakedClip& clip : source.character->clips) {
    roles.turns.push_back(anim::root_velocity(clip.root_motion, 0).yaw / (0.5 * std::numbers::pi));
  }
  roles.walk_speed = gait_speed(source, Role::walk);
  const double jog = gait_speed(source, Role::jog), run = gait_speed(source, Role::run);
  roles.jog_speed = jog > least_gain * roles.walk_speed ? jog : 0.0;
  roles.run_speed = run > least_gain * std::max(roles.walk_speed, roles.jog_speed) ? run : 0.0;
  for (const Role gait : gait_roles) roles.velocities[index_of(gait)] = gait_velocity(source, gait);
  glm::dvec2& shuffle = roles.velocities[index_of(Role::shuffle)];
  if (least_gain * glm::length(shuffle) > roles.walk_speed) shuffle = glm::dvec2(0.0);
  if (!roles.can_walk()) return;
  const auto walk = static_cast<std::size_t>(roles.clip(Role::walk));
  roles.walk_seconds = to_seconds(source.character->clips[walk].duration);
}

namespace {

render::PieceLevelData level_data(const std::vector<anim::SkinnedMesh>& meshes, double error, const auto& part_of) {
  render::PieceLevelData level{.parts = {}, .error = static_cast<float>(error)};
  for (const anim::SkinnedMesh& mesh : meshes) level.parts.push_back(part_of(mesh));
  return level;
}

render::MeshPieceData piece_data(const anim::ModelPart& part, const auto& part_of) {
  render::MeshPieceData piece{.levels = {}, .is_silhouette = part.slot == anim::silhouette_slot};
  piece.levels.push_back(level_data(part.meshes, part.error, part_of));
  for (const anim::BakedMeshLod& lod : part.lods) piece.levels.push_back(level_data(lod.meshes, lod.error, part_of));
  return piece;
}

}  // namespace

render::CrowdMeshData mesh_data(const CharacterSource& source) {
  const anim::Model& model = source.model;
  render::CrowdMeshData data;
  data.packed_surface = source.surface.bytes;
  const auto part_of = [&model](const anim::SkinnedMesh& mesh) {
    return part_data(mesh, model.materials[static_cast<std::size_t>(mesh.material)]);
  };
  for (const anim::SkinnedMesh& mesh : model.meshes) data.parts.push_back(part_of(mesh));
  for (const anim::BakedMeshLod& lod : model.mesh_lods) {
    render::BakedLodData& baked = data.baked_lods.emplace_back();
    for (const anim::SkinnedMesh& mesh : lod.meshes) baked.parts.push_back(part_of(mesh));
  }
  for (const anim::ModelPart& part : model.parts) data.pieces.push_back(piece_data(part, part_of));
  add_materials(model.materials, model.images, data);
  add_palette_data(model.skeleton, data);
  data.morph_deltas = morph_deltas(model.meshes);
  data.body_size = size_of_body(source.roles);
  if (!data.packed_surface.empty()) return data;
  data.face_entries = face_entries(skeleton_in_file(source));
  data.poses = posed_palettes(model);
  data.bone_ends = bone_ends(model.skeleton);
  return data;
}

void build_surface(CharacterSource& source) {
  if (!source.surface.bytes.empty()) return;
  const auto packed = std::make_shared<const std::vector<std::byte>>(
      render::pack_surface(render::view_of(render::build_surface(mesh_data(source)))));
  source.surface = {.bytes = *packed, .lender = packed};
}

}  // namespace throng::app
