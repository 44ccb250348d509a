#include "engine/anim/agent/channel/slot_channel.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "engine/anim/base/misuse.h"

namespace throng::anim {
namespace {

PlayerStart start_of(const EntityBuilder& build, const OneShot& shot) {
  const Ticks begin = shot.speed < 0.0 && build.has_clip(shot.clip) ? build.clip(shot.clip).duration : Ticks{};
  return {.clip = shot.clip, .speed = shot.speed, .start = begin, .loop = false};
}

const char* fault_of(const EntityBuilder& build, const OneShot& shot) {
  if (const char* fault = build.fault_of(start_of(build, shot)); fault != nullptr) return fault;
  if (std::abs(shot.speed) < slowest_speed) return "a one-shot of no speed has no end";
  return is_fade(shot.fade_in) && is_fade(shot.fade_out) ? nullptr : not_a_fade;
}

/// Makes a blender stand where it is if it began, or will begin, at a time of the clock.
void begin_at(const EntityBuilder& build, Handle blender, Ticks begins, Ticks total) {
  auto& own = build.as<EaseBlender>(blender);
  own.total = total;
  own.elapsed = build.lead() + (build.now() - begins);
}

}  // namespace

bool SlotChannel::play(const OneShot& shot) {
  if (!shot.queued) asked_count_ = 0;
  const bool replaces_all = asked_count_ > 0 && !asked_[0].queued;
  const std::size_t before = asked_count_ + (replaces_all ? 0 : tree_.count);
  if (shot.queued && before >= OneShotTree::max_shots) {
    refused_ = true;
    return false;
  }
  asked_[asked_count_++] = shot;
  return true;
}

void SlotChannel::stop() {
  asked_count_ = 0;
  stops_ = true;
}

bool SlotChannel::update(const EntityBuilder& build) {
  bool changed = end_interruption(build, inertialiser_, left_);
  changed = end_shots(build) || changed;
  took_all_ = !std::exchange(refused_, false);
  if (stops_) {
    destroy_entities(build);
    changed = true;
  }
  for (std::size_t i = 0; i < asked_count_; ++i) {
    const bool taken = take(build, asked_[i]);
    took_all_ = took_all_ && taken;
    changed = changed || taken;
  }
  asked_count_ = 0;
  stops_ = false;
  return changed;
}

bool SlotChannel::take(const EntityBuilder& build, const OneShot& shot) {
  if (const char* fault = fault_of(build, shot); fault != nullptr) {
    report_misuse({"Agent::play_once", fault});
    return false;
  }
  const Ticks now = build.now();
  if (shot.queued && is_playing(now) && now < fades_out_at_) {
    const Ticks begins = std::max({now, tree_.last().ends - shot.fade_in, tree_.last().begins});
    append(build, shot, begins, true);
  } else if (tree_.empty()) {
    append(build, shot, now, shot.fade_in > Ticks{});
  } else if (shot.fade_in > Ticks{}) {
    interrupt(build, shot);
  } else {
    destroy_entities(build);
    append(build, shot, now, false);
  }
  return true;
}

void SlotChannel::append(const EntityBuilder& build, const OneShot& shot, Ticks begins, bool fades_in) {
  constexpr Ticks at_once{1};  // a blender of no time has eased before it begins
  const Ticks fade_in = std::max(shot.fade_in, at_once);
  const Handle player = build.player(start_of(build, shot));
  auto& own = build.as<Player>(player);
  build.seek(own, build.position(own) - distance(begins - build.now(), own.speed));
  OneShotTree::Shot& added = tree_.shots[tree_.count++];
  added = {.begins = begins,
           .ends = begins + build.length_of(player),
           .faded_in = begins + fade_in,
           .player = player,
           .in = fades_in ? build.ease({}, player, fade_in) : Handle{}};
  if (fades_in) begin_at(build, added.in, begins, fade_in);
  if (!tree_.out.valid()) tree_.out = build.ease({}, {}, at_once);
  const Ticks fade_out = std::clamp(shot.fade_out, at_once, std::max(added.ends - begins, at_once));
  fades_out_at_ = added.ends - fade_out;
  begin_at(build, tree_.out, fades_out_at_, fade_out);
}

void SlotChannel::interrupt(const EntityBuilder& build, const OneShot& shot) {
  begin_interruption(build, inertialiser_, tree_, left_);
  append(build, shot, build.now(), false);
  retarget(build.as<Inertialiser>(inertialiser_), tree_.root(has_below_), left_.root(has_below_),
           half_life_of(shot.fade_in));
}

void SlotChannel::lie_over(const EntityBuilder& build, Handle below) {
  has_below_ = below.valid();
  tree_.join(build, below);
  left_.join(build, below);
  if (!inertialiser_.valid()) return;
  auto& inertialiser = build.as<Inertialiser>(inertialiser_);
  inertialiser.target = tree_.root(has_below_);
  if (!left_.empty()) inertialiser.leaving = left_.root(has_below_);
}

// An inertialiser shows its offset over the shots, so they stay until it has ended.
bool SlotChannel::end_shots(const EntityBuilder& build) {
  if (tree_.empty()) return false;
  if (build.now() >= tree_.last().ends && !inertialiser_.valid()) {
    tree_.destroy(build);
    return true;
  }
  return tree_.drop_covered(build);
}

Ticks SlotChannel::next_update() const {
  if (inertialiser_.valid()) return Ticks{};
  return tree_.empty() ? never : std::min(tree_.last().ends, tree_.next_faded_in());
}

void SlotChannel::visit_handles(const std::function<void(Handle&)>& visit) {
  tree_.visit_handles(visit);
  left_.visit_handles(visit);
  if (inertialiser_.valid()) visit(inertialiser_);
}

void SlotChannel::destroy_entities(const EntityBuilder& build) {
  tree_.destroy(build);
  cut_interruption(build, inertialiser_, left_);
}

}  // namespace throng::anim
