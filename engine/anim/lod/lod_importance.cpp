#include "engine/anim/lod/lod_importance.h"

#include <algorithm>

namespace throng::anim {
namespace {

constexpr float importance_of_selected = 4.0F;
constexpr float importance_of_fading = 2.0F;

}  // namespace

void LodImportance::reset(std::size_t agents) {
  importance_.assign(agents, 1.0F);
  changing_.assign(agents, 0);
  fades_until_.assign(agents, Ticks{});
  fading_.clear();
  fading_.reserve(agents);
  selected_.reset();
}

void LodImportance::fade(std::uint32_t agent, Ticks until) {
  if (fades_until_[agent] == Ticks{}) fading_.push_back(agent);
  fades_until_[agent] = std::max(until, Ticks{1});
}

void LodImportance::weigh(Ticks now, std::optional<std::uint32_t> selected) {
  if (selected_) importance_[*selected_] = 1.0F;
  std::erase_if(fading_, [&](std::uint32_t agent) {
    const bool over = fades_until_[agent] <= now;
    importance_[agent] = over ? 1.0F : importance_of_fading;
    changing_[agent] = over ? 0 : 1;
    if (over) fades_until_[agent] = Ticks{};
    return over;
  });
  selected_ = selected;
  if (selected_) importance_[*selected_] = importance_of_selected;
}

}  // namespace throng::anim
