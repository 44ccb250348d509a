#include "app/commands/bake/command.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/character/built_in.h"
#include "app/character/clip_files.h"
#include "app/character/model_file.h"
#include "app/character/skin_choice.h"
#include "app/character/source.h"
#include "app/files/exit_status.h"
#include "app/show/figures/notices.h"
#include "engine/anim/asset/placement.h"
#include "engine/anim/bake/clip_set.h"
#include "engine/anim/pack/pack.h"
#include "engine/base/files/output_file.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"
#include "engine/base/text/size_text.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app {
namespace {

/// Clips of other files belong to the file that is packed, so that it can be baked anew with them.
Status add_clips(const std::string& path, const BakeOptions& options, std::size_t characters,
                 anim::ImportedFile& file) {
  if (options.clips_from.empty()) return Done{};
  const auto clips = read_clip_files(options.clips_from, options.reading);
  if (!clips) return clips.error();
  anim::face_forward(file);
  for (std::size_t model = 0; model < characters; ++model) {
    if (const auto taken = take_kept_rig(path, file.models[model].skeleton); !taken) return taken.error();
    if (const auto added = add_clips_from(pointers_to(*clips), file, model); !added) return added.error();
  }
  return Done{};
}

std::shared_ptr<const anim::Character> without_spare_keys(const std::shared_ptr<const anim::Character>& character) {
  anim::Character lean = anim::lend_character(character);
  anim::keep_played_streams(lean);
  return std::make_shared<const anim::Character>(std::move(lean));
}

Result<pack::CharacterToPack> bake_model(const std::string& path, const BakeOptions& options,
                                         const anim::ImportedFile& file, std::size_t model) {
  const BoneLodFile kept(path);
  auto order = kept.read(file.models[model].skeleton);
  if (!order) return order.error();
  anim::ImportedFile baked = file;
  auto source = make_character(baked, model,
                               {.path = path, .name = {}, .kept = &kept, .placement = options.placement, .clips = {}});
  if (!source) return source.error();
  pack::CharacterToPack character{
      .name = {},
      .prepared = {std::move(source->placement), std::move(*order)},
      .character = options.keep_keys ? source->character : without_spare_keys(source->character),
      .surface = {}};
  if (source->has_surface()) {
    character.surface = render::pack_surface(render::view_of(render::build_surface(mesh_data(*source))));
  }
  return character;
}

/// Returns names of the characters of a file; of its first skeleton where no model has a mesh.
std::vector<std::string> names_of(const anim::ImportedFile& file) {
  std::vector<std::string> names = character_names(file);
  if (names.empty()) names.push_back(file.models.front().skeleton.name);
  return names;
}

/// Returns the file's name without folder and ending, made one that no other file has.
std::string name_for(const std::string& path, const std::vector<pack::FileToPack>& files) {
  const std::string stem = plain_text(std::filesystem::path(character_file(path).path).stem().string());
  std::string name = stem;
  const auto is_taken = [&] { return std::ranges::count(files, name, &pack::FileToPack::name) > 0; };
  for (int number = 2; is_taken(); ++number) name = stem + " " + std::to_string(number);
  return name;
}

Result<pack::FileToPack> bake_file(const std::string& path, const BakeOptions& options) {
  auto file = read_model_file(path, options.reading);
  if (!file) return file.error();
  pack::FileToPack packed{.name = {}, .file = std::move(*file), .characters = {}};
  packed.with_keys = options.keep_keys;
  const std::vector<std::string> names = names_of(packed.file);
  if (Status added = add_clips(path, options, names.size(), packed.file); !added) return added.error();
  for (std::size_t model = 0; model < names.size(); ++model) {
    auto character = bake_model(path, options, packed.file, model);
    if (!character) return character.error();
    character->name = names[model];
    packed.characters.push_back(std::move(*character));
  }
  return packed;
}

/// Counts the bytes of the parts of a pack.
struct PackSizes {
  std::size_t streams = 0, surfaces = 0, texels = 0;

  void add(const pack::FileToPack& file) {
    for (const pack::CharacterToPack& packed : file.characters) {
      surfaces += packed.surface.size();
      for (const anim::BakedClip& clip : packed.character->clips) {
        if (clip.keyframe() != nullptr) streams += clip.keyframe()->total_size;
        if (clip.sampled() != nullptr) streams += clip.sampled()->total_size;
      }
    }
    for (const anim::Model& model : file.file.models) {
      for (const anim::Image& image : model.images) texels += image.rgba.size();
    }
  }
};

/// Lists what was baked of a file, with notes for a person.
std::string told_of(const std::string& path, const pack::FileToPack& file) {
  std::size_t clips = 0;
  for (const pack::CharacterToPack& packed : file.characters) clips += packed.character->clips.size();
  CharacterSource told;
  told.file = path;
  told.repairs = file.file.repairs;
  told.notes = file.file.notes;
  const std::string notice = import_notice({&told, 1});
  return file.name + ": " + counted(file.characters.size(), "character") + ", " + counted(clips, "clip") + "\n" +
         (notice.empty() ? "" : notice + "\n");
}

using FilesToPack = std::vector<pack::FileToPack>;

Result<FilesToPack> bake_built_in(const BakeOptions& options) {
  const auto files = find_built_in(options.data, true);
  if (!files) return files.error();
  auto file = built_in_to_pack(*files);
  if (!file) return file.error();
  FilesToPack packed;
  packed.push_back(std::move(*file));
  return packed;
}

Result<FilesToPack> bake_models(const BakeOptions& options) {
  FilesToPack files;
  for (const std::string& path : options.models) {
    auto file = bake_file(path, options);
    if (!file) return file.error();
    file->name = name_for(path, files);
    if (Status told = print(told_of(path, *file)); !told) return told.error();
    files.push_back(std::move(*file));
  }
  return files;
}

Status bake(const BakeOptions& options) {
  const auto baked = options.built_in ? bake_built_in(options) : bake_models(options);
  if (!baked) return baked.error();
  const FilesToPack& files = *baked;
  PackSizes sizes;
  for (const pack::FileToPack& file : files) sizes.add(file);
  const std::vector<std::byte> pack = pack::write_pack(files);
  Status written = write_whole_file(options.pack, {reinterpret_cast<const char*>(pack.data()), pack.size()});
  if (!written) return written;
  return print(plain_text(options.pack) + ": " + size_text(pack.size()) + ", of which streams " +
               size_text(sizes.streams) + ", surfaces " + size_text(sizes.surfaces) + ", texels " +
               size_text(sizes.texels) + "\n");
}

}  // namespace

int run_bake(const BakeOptions& options) { return end_with(bake(options)); }

}  // namespace throng::app
