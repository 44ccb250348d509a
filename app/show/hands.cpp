// What a person asks of a show while it runs, and what of it a recording keeps.
#include <utility>

#include "app/character/bone_lod.h"
#include "app/character/lod_export.h"
#include "app/character/role_table.h"
#include "app/show/show.h"

namespace throng::app {

void Show::set_roles(std::size_t character, const RoleClips& clips) {
  stage_->set_roles(character, clips);
  if (recorder_) recorder_->add(RecordedRoles{static_cast<std::uint32_t>(character), clips});
}

anim::Result<std::filesystem::path> Show::save_roles(std::size_t index) const {
  const CharacterSource& character = stage_->characters()[index];
  return RoleFile(character.file).write(all_choices(character.roles.clips, character.clip_names));
}

anim::Status Show::set_bone_lod(std::size_t character, const BoneLodChoice& choice) {
  if (anim::Status set = stage_->set_bone_lod(character, choice); !set) return set;
  if (recorder_) recorder_->add(RecordedBoneOrder{static_cast<std::uint32_t>(character), choice});
  return load_meshes(*stage_);
}

anim::Result<std::filesystem::path> Show::save_bone_lod(std::size_t index) const {
  const CharacterSource& character = stage_->characters()[index];
  return BoneLodFile(character.file).write(character.character->skeleton);
}

anim::Result<std::filesystem::path> Show::export_lod(std::size_t index) const {
  const CharacterSource& character = stage_->characters()[index];
  std::span<const std::uint32_t> triangles;
  if (renderer_ != nullptr) triangles = renderer_->meshes()[index].triangles_by_lod();
  const double pixels_per_unit = static_cast<double>(render::pixels_tall(camera, static_cast<float>(height), 1, 1));
  return KeptFile(character.file, ".lod.export.json", "The level of detail")
      .write(lod_as_json(character, lod_levels(character, triangles), stage_->tuning().lod, pixels_per_unit));
}

void Show::select_at(float x, float y) {
  const auto size = glm::vec2(glm::ivec2(width, height));
  const auto picked = pick(ray_through(camera, {x, y}, size), stage_->bodies_in_view());
  select(picked ? std::optional(picked->agent) : std::nullopt);
}

void Show::select(std::optional<std::uint32_t> agent) {
  stage_->select(agent);
  if (recorder_) recorder_->add(RecordedSelection{agent});
}

void Show::hold_clip(std::uint32_t agent, float seconds) {
  stage_->animated().hold_clip(agent, seconds);
  if (recorder_) recorder_->add(RecordedHold{agent, seconds});
}

void Show::hold_selected_clip(float seconds) {
  if (const auto selected = stage_->selected()) hold_clip(*selected, seconds);
}

void Show::let_go_of_clip() {
  stage_->animated().let_go_of_clip();
  if (recorder_) recorder_->add(RecordedHold{});
}

anim::Status Show::rewind() {
  anim::Status gone = rewind_.go_back(*stage_);
  if (gone && recorder_) recorder_->add(RecordedRewind{});
  return gone;
}

anim::Status Show::push_selected() {
  const auto selected = stage_->selected();
  return selected ? push(*selected, render::forward(camera)) : anim::Done{};
}

anim::Status Show::push(std::uint32_t agent, const glm::vec3& direction) {
  anim::Status pushed = stage_->animated().push_over(agent, direction);
  if (pushed && recorder_) recorder_->add(RecordedPush{agent, direction});
  return pushed;
}

anim::Status Show::start_recording(const std::filesystem::path& file) {
  auto recorder = RecordingWriter::create(
      file, {.characters = recorded(stage_->people()), .tuning = stage_->tuning(), .width = width, .height = height});
  if (!recorder) return recorder.error();
  if (stage_->frame() > 0) stage_->restart();
  rewind_.forget();
  keep_moments();
  recorder_ = std::move(*recorder);
  return anim::Done{};
}

anim::Status Show::stop_recording() {
  if (recorder_ == nullptr) return anim::Done{};
  return std::exchange(recorder_, nullptr)->finish();
}

}  // namespace throng::app
