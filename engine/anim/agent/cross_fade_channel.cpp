#include "engine/anim/agent/cross_fade_channel.h"

#include <algorithm>

namespace throng::anim {
namespace {

constexpr std::size_t player_place(std::size_t player) { return player == 0 ? 0 : 2 * player - 1; }

bool stays(const PlayRequest& request) {
  return request.held_fraction.has_value() || request.mask != PlayRequest::no_mask;
}

}  // namespace

void BlendTree::destroy(const EntityBuilder& build) {
  for (const Handle entity : all()) build.destroy(entity);
  count = 0;
}

PlayerStart start_of(const PlayRequest& request) {
  return {.clip = request.clip,
          .speed = request.speed,
          .start = request.start,
          .loop = request.loop,
          .absolute_root = request.absolute_root,
          .bone_selection = request.bone_selection};
}

bool CrossFadeChannel::play(const EntityBuilder& build, const PlayRequest& request) {
  end_fades(build);
  end_interruption(build, inertialiser_, left_);
  const bool full = tree_.player_count() == BlendTree::max_players;
  if (tree_.count == 0 || (request.fade <= Ticks{} && !stays(request))) {
    cut(build, request);
  } else if (stays(request)) {
    if (full) return false;
    lay_over(build, request, never);
  } else if (full || settled_at_ > build.now() || is_fading(build.now())) {
    interrupt(build, request);
  } else {
    lay_over(build, request, build.now() + request.fade);
  }
  return true;
}

void CrossFadeChannel::cut(const EntityBuilder& build, const PlayRequest& request) {
  destroy_entities(build);
  tree_.entities[tree_.count++] = build.player(start_of(request));
}

void CrossFadeChannel::lay_over(const EntityBuilder& build, const PlayRequest& request, Ticks fade_end) {
  const Handle from = tree_.root();
  const Handle to = build.player(start_of(request));
  const Handle blender = request.held_fraction ? build.hold(from, to, *request.held_fraction, request.mask)
                                               : build.ease(from, to, request.fade, request.mask);
  fade_end_[tree_.player_count()] = fade_end;
  tree_.entities[tree_.count++] = to;
  tree_.entities[tree_.count++] = blender;
  if (inertialiser_.valid()) build.as<Inertialiser>(inertialiser_).target = blender;
}

void CrossFadeChannel::interrupt(const EntityBuilder& build, const PlayRequest& request) {
  begin_interruption(build, inertialiser_, tree_, left_);
  tree_.entities[tree_.count++] = build.player(start_of(request));
  settled_at_ = build.now() + request.fade;
  retarget(build.as<Inertialiser>(inertialiser_), tree_.root(), left_.root(), half_life_of(request.fade));
}

Handle CrossFadeChannel::newest_player() const {
  return tree_.empty() ? Handle{} : tree_.entities[player_place(tree_.player_count() - 1)];
}

bool CrossFadeChannel::update(const EntityBuilder& build) {
  const bool faded = end_fades(build);
  return end_interruption(build, inertialiser_, left_) || faded;
}

// Replaces every fade that is over by its target, so that trees stay shallow.
bool CrossFadeChannel::end_fades(const EntityBuilder& build) {
  std::size_t over = tree_.player_count();
  while (over > 0 && --over > 0 && fade_end_[over] > build.now()) {
  }
  if (over == 0) return false;
  const std::size_t kept = player_place(over);
  for (std::size_t i = 0; i < kept; ++i) build.destroy(tree_.entities[i]);
  build.destroy(tree_.entities[kept + 1]);
  BlendTree shorter;
  shorter.entities[shorter.count++] = tree_.entities[kept];
  for (std::size_t i = kept + 2; i < tree_.count; ++i) shorter.entities[shorter.count++] = tree_.entities[i];
  for (std::size_t i = 1; i < shorter.player_count(); ++i) fade_end_[i] = fade_end_[over + i];
  if (shorter.count > 1) build.as<EaseBlender>(shorter.entities[2]).from = shorter.entities[0];
  tree_ = shorter;
  if (inertialiser_.valid()) build.as<Inertialiser>(inertialiser_).target = tree_.root();
  return true;
}

bool CrossFadeChannel::is_fading(Ticks now) const {
  for (std::size_t i = 1; i < tree_.player_count(); ++i) {
    if (fade_end_[i] != never && fade_end_[i] > now) return true;
  }
  return false;
}

Ticks CrossFadeChannel::next_update() const {
  if (inertialiser_.valid()) return Ticks{};
  Ticks next = never;
  for (std::size_t i = 1; i < tree_.player_count(); ++i) next = std::min(next, fade_end_[i]);
  return next;
}

void CrossFadeChannel::visit_handles(const std::function<void(Handle&)>& visit) {
  for (std::size_t i = 0; i < tree_.count; ++i) visit(tree_.entities[i]);
  for (std::size_t i = 0; i < left_.count; ++i) visit(left_.entities[i]);
  if (inertialiser_.valid()) visit(inertialiser_);
}

void CrossFadeChannel::destroy_entities(const EntityBuilder& build) {
  tree_.destroy(build);
  cut_interruption(build, inertialiser_, left_);
  settled_at_ = Ticks{};
}

}  // namespace throng::anim
