#include "app/show/thresholds_in_view.h"

#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

/// Another clip is shown once so many times as many play it, so that rings do not jump to and fro.
constexpr double clearly_more = 1.2;

}  // namespace

void ThresholdsInView::pick_clip(const Stage& stage) {
  const Crowd& crowd = stage.crowd();
  agents_.resize(stage.characters().size());
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    agents_[i].assign(stage.characters()[i].character->clips.size() + 1, 0);
  }
  for (const anim::VisibleAgent& seen : stage.posed().selection().visible) {
    ++agents_[crowd.characters()[seen.agent]][static_cast<std::size_t>(crowd.minds().clips()[seen.agent]) + 1];
  }
  const auto place = static_cast<std::size_t>(clip_) + 1;
  const bool is_known = character_ < agents_.size() && place < agents_[character_].size();
  if (!is_known) {  // other characters have come, and no agent may be in view
    character_ = 0;
    clip_ = no_clip;
  }
  double most = is_known ? clearly_more * agents_[character_][place] : 0;
  for (std::size_t character = 0; character < agents_.size(); ++character) {
    for (std::size_t clip = 0; clip < agents_[character].size(); ++clip) {
      if (agents_[character][clip] <= most) continue;
      most = agents_[character][clip];
      character_ = character;
      clip_ = static_cast<int>(clip) - 1;
    }
  }
}

void ThresholdsInView::update(const Stage& stage, const render::Camera& lod_camera, int height) {
  const Tuning& tuning = stage.tuning();
  thresholds_.clear();
  clip_name_.clear();
  if (tuning.lod.rule == LodRule::distance) thresholds_ = interval_thresholds(tuning);
  const float tolerance = stage.posed().level_of_detail().figures().tolerance_px;
  if (tuning.lod.rule != LodRule::budget || tolerance <= 0) return;
  pick_clip(stage);
  const CharacterSource& character = stage.characters()[character_];
  clip_name_ = clip_ == no_clip ? "standing still" : character.clip_names[static_cast<std::size_t>(clip_)];
  thresholds_ =
      interval_thresholds(stage.posed().level_of_detail().choices().of(character_, clip_),
                          {.tolerance_pixels = tolerance,
                           .pixels_per_unit = render::pixels_tall(lod_camera, static_cast<float>(height), 1.0F, 1.0F)});
}

}  // namespace throng::app
