#include "engine/anim/agent/channel/one_shot_tree.h"

#include <algorithm>

namespace throng::anim {
namespace {

void destroy_shot(const EntityBuilder& build, const OneShotTree::Shot& shot) {
  build.destroy(shot.player);
  if (shot.in.valid()) build.destroy(shot.in);
}

}  // namespace

Ticks OneShotTree::next_faded_in() const {
  Ticks next = never;
  for (std::size_t i = 0; i < count; ++i) {
    if (shots[i].in.valid()) next = std::min(next, shots[i].faded_in);
  }
  return next;
}

void OneShotTree::join(const EntityBuilder& build, Handle below) const {
  Handle root = below;
  for (std::size_t i = 0; i < count; ++i) {
    if (!root.valid() || !shots[i].in.valid()) {
      root = shots[i].player;
      continue;
    }
    auto& in = build.as<EaseBlender>(shots[i].in);
    in.from = root;
    in.to = shots[i].player;
    root = shots[i].in;
  }
  if (empty() || !below.valid()) return;
  auto& own_out = build.as<EaseBlender>(out);
  own_out.from = root;
  own_out.to = below;
}

Handle OneShotTree::root(bool has_below) const {
  if (empty()) return {};
  if (has_below) return out;
  return count > 1 && last().in.valid() ? last().in : last().player;
}

bool OneShotTree::drop_covered(const EntityBuilder& build) {
  if (next_faded_in() > build.now()) return false;
  std::size_t dropped = count - 1;
  while (!shots[dropped].in.valid() || shots[dropped].faded_in > build.now()) --dropped;
  for (std::size_t i = 0; i < dropped; ++i) destroy_shot(build, shots[i]);
  build.destroy(shots[dropped].in);
  shots[dropped].in = {};
  for (std::size_t i = dropped; i < count; ++i) shots[i - dropped] = shots[i];
  count -= dropped;
  return true;
}

void OneShotTree::destroy(const EntityBuilder& build) {
  for (std::size_t i = 0; i < count; ++i) destroy_shot(build, shots[i]);
  if (out.valid()) build.destroy(out);
  *this = {};
}

void OneShotTree::visit_handles(const std::function<void(Handle&)>& visit) {
  for (std::size_t i = 0; i < count; ++i) {
    visit(shots[i].player);
    if (shots[i].in.valid()) visit(shots[i].in);
  }
  if (out.valid()) visit(out);
}

}  // namespace throng::anim
