#include "engine/anim/agent/channel/clip_mix_channel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/anim/base/misuse.h"
#include "engine/anim/entity/mixer.h"

namespace throng::anim {
namespace {

bool has_no_clip_twice(std::span<const MixedClip> clips) {
  for (std::size_t i = 1; i < clips.size(); ++i) {
    if (std::ranges::count(clips.first(i), clips[i].clip, &MixedClip::clip) > 0) return false;
  }
  return true;
}

bool can_be_mixed(const MixedClip& one) {
  return std::isfinite(one.weight) && one.weight > 0.0F && is_speed(one.speed);
}

void speak(Player& player, StepVoice voice) {
  player.flags &= ~(Player::leads_step | Player::in_step);
  if (voice == StepVoice::leads) player.flags |= Player::leads_step;
  if (voice == StepVoice::follows) player.flags |= Player::in_step;
}

}  // namespace

void ClipMixChannel::set(std::span<const MixedClip> clips) {
  const bool fits = !clips.empty() && clips.size() <= most;
  if (!fits || !has_no_clip_twice(clips) || !std::ranges::all_of(clips, can_be_mixed)) {
    report_misuse({"ClipMixChannel::set", "a mix has one to five clips, none twice, with weights above 0"});
    return;
  }
  std::ranges::copy(clips, clips_.begin());
  count_ = clips.size();
}

const char* ClipMixChannel::fault(const EntityBuilder& build) const {
  if (count_ == 0) return "the mix has no clip";
  const bool has_all = std::ranges::all_of(clips(), [&](const MixedClip& one) { return build.has_clip(one.clip); });
  return has_all ? nullptr : "a clip of the mix is not one that the character has";
}

bool ClipMixChannel::update(const EntityBuilder& build) {
  if (fault(build) != nullptr) {
    report_misuse({"ClipMixChannel::update", "a clip of the mix is not one that the character has"});
    return false;
  }
  const bool others = take_players(build);
  place_players(build);
  return blend(build) || others;
}

bool ClipMixChannel::take_players(const EntityBuilder& build) {
  const std::array<Handle, most> before = players_;
  const std::array<int, most> played = played_;
  const std::size_t had = std::exchange(played_count_, count_);
  bool changed = had != count_;
  std::array<bool, most> kept{};
  for (std::size_t i = 0; i < count_; ++i) {
    played_[i] = clips_[i].clip;
    players_[i] = {};
    for (std::size_t old = 0; old < had; ++old) {
      if (played[old] != clips_[i].clip) continue;
      players_[i] = before[old];
      kept[old] = true;
      changed = changed || old != i;
    }
    if (players_[i].valid()) continue;
    players_[i] = build.player({.clip = clips_[i].clip});
    changed = true;
  }
  for (std::size_t old = 0; old < had; ++old) {
    if (!kept[old]) build.destroy(before[old]);
  }
  for (std::size_t i = count_; i < most; ++i) players_[i] = {};
  return changed;
}

void ClipMixChannel::place_players(const EntityBuilder& build) const {
  for (std::size_t i = 0; i < count_; ++i) {
    build.set_speed(players_[i], clips_[i].speed);
    build.seek(players_[i], clips_[i].position);
    speak(build.as<Player>(players_[i]), clips_[i].voice);
  }
}

bool ClipMixChannel::blend(const EntityBuilder& build) {
  const Handle before = blend_;
  const bool is_mixer = blend_.valid() && build.pools().state(blend_).type == EntityType::mixer;
  const bool fits = blend_.valid() && count_ > 1 && is_mixer == (count_ > 2);
  if (blend_.valid() && !fits) build.destroy(std::exchange(blend_, {}));
  if (count_ == 1) return blend_ != before;
  if (count_ == 2) {
    const float share = clips_[1].weight / (clips_[0].weight + clips_[1].weight);
    if (!blend_.valid()) blend_ = build.hold(players_[0], players_[1], share);
    auto& blender = build.as<EaseBlender>(blend_);
    blender.from = players_[0];
    blender.to = players_[1];
    blender.fraction = share;
    return blend_ != before;
  }
  if (!blend_.valid()) blend_ = build.create(EntityPools::mixers);
  auto& mixer = build.as<Mixer>(blend_);
  auto& mixed = build.private_as<MixerSources>(blend_);
  mixer.source_count = static_cast<std::uint32_t>(count_);
  std::ranges::fill(mixer.masks, EaseBlender::no_mask);
  for (std::size_t i = 0; i < count_; ++i) {
    mixed.sources[i] = players_[i];
    mixed.weights[i] = clips_[i].weight;
  }
  return blend_ != before;
}

void ClipMixChannel::visit_handles(const std::function<void(Handle&)>& visit) {
  for (std::size_t i = 0; i < played_count_; ++i) visit(players_[i]);
  if (blend_.valid()) visit(blend_);
}

void ClipMixChannel::destroy_entities(const EntityBuilder& build) {
  for (std::size_t i = 0; i < played_count_; ++i) build.destroy(std::exchange(players_[i], {}));
  played_count_ = 0;
  if (blend_.valid()) build.destroy(std::exchange(blend_, {}));
}

}  // namespace throng::anim
