// Other characters while the crowd runs: all of the change, or nothing of it.
#include <string>
#include <utility>

#include "app/character/files.h"
#include "app/show/show.h"

namespace throng::app {

anim::Status Show::replace_models(std::span<const std::string> files) {
  if (files.size() > most_models) {
    return anim::Error{std::to_string(files.size()) + " models at once: at most " + std::to_string(most_models) +
                       " share a crowd"};
  }
  auto characters = load_characters(files);
  if (!characters) return characters.error();
  for (CharacterSource& character : *characters) {
    if (const anim::Status kept = take_kept_roles(character); !kept) return kept.error();
  }
  return replace_characters(std::move(*characters));
}

anim::Status Show::replace_characters(std::vector<CharacterSource> characters) {
  render::PalettePageSource& pages = renderer_ != nullptr ? renderer_->palette_pages() : *heap_pages_;
  auto stage = Stage::create(std::move(characters), stage_->tuning(), pages, stage_->frame());
  if (!stage) return stage.error();
  if (const anim::Status loaded = load_meshes(**stage); !loaded) return loaded.error();
  if (renderer_ != nullptr) renderer_->reset_palette_pages();  // the new stage has asked for none yet
  stage_ = std::move(*stage);
  rewind_.forget();
  if (recorder_) recorder_->add(RecordedCharacters{recorded(stage_->people())});
  update_notice();
  return anim::Done{};
}

anim::Status Show::load_meshes(const Stage& stage) {
  if (renderer_ == nullptr) return anim::Done{};
  std::vector<render::CrowdMeshData> meshes;
  for (const CharacterSource& character : stage.characters()) meshes.push_back(mesh_data(character.model));
  return renderer_->load_characters(meshes);
}

}  // namespace throng::app
