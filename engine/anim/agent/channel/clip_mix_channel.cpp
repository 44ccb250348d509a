#include "engine/anim/agent/channel/clip_mix_channel.h"

#include <algorithm>
#include <cmath>

#include "engine/anim/base/misuse.h"

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
  std::array<BlendedPlayers::Wanted, most> wanted;
  std::array<float, most> weights{};
  for (std::size_t i = 0; i < count_; ++i) {
    wanted[i] = {.key = static_cast<std::size_t>(clips_[i].clip), .clip = clips_[i].clip};
    weights[i] = clips_[i].weight;
  }
  if (count_ == 2) weights[1] /= weights[0] + weights[1];
  const bool others = players_.take(build, std::span(wanted).first(count_));
  place_players(build);
  return players_.blend(build, weights) || others;
}

void ClipMixChannel::place_players(const EntityBuilder& build) const {
  for (std::size_t i = 0; i < count_; ++i) {
    auto& player = build.as<Player>(players_.player(i));
    build.set_speed(player, clips_[i].speed);
    build.seek(player, clips_[i].position);
    speak(player, clips_[i].voice);
  }
}

}  // namespace throng::anim
