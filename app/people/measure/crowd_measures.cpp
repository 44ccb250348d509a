#include "app/people/measure/crowd_measures.h"

#include <algorithm>
#include <span>

#include <glm/geometric.hpp>

#include "engine/base/tiles.h"

namespace throng::app {
namespace {

constexpr float unknown = -1.0F;

}  // namespace

float speed_of(const Followers& followers, std::size_t agent, double seconds, double window) {
  return glm::length(followers.way(agent).velocity(seconds, std::max(window, TrackSteps::stride_window)));
}

void CrowdMeasures::take(const Crowd& crowd, const Tuning& tuning, Executor& executor, int jobs) {
  const FollowedTracks* const tracks = crowd.tracks();
  const double seconds = tracks != nullptr ? tracks->clock().seconds : 0.0;
  const std::span<const std::uint8_t> absent = absent_of(crowd);
  const auto measure_each = [&](const auto& measure) {  // of a recorded crowd; an absent person may have no row
    visit_in_tiles(crowd.size(), executor, jobs,
                   [&](std::size_t agent) { values_[agent] = absent[agent] != 0 ? unknown : measure(agent); });
  };
  values_.resize(crowd.size());
  switch (tuning.debug_view) {
    case DebugView::speed:
      if (tracks == nullptr) {
        values_.assign(crowd.speeds().begin(), crowd.speeds().end());
      } else {
        measure_each([&](std::size_t agent) { return speed_of(tracks->people(), agent, seconds); });
      }
      break;
    case DebugView::density:
      take_densities(crowd, tuning.density_cut_off, executor, jobs);
      break;
    case DebugView::presence:
      if (tracks == nullptr) {
        std::ranges::fill(values_, unknown);
      } else {
        measure_each(
            [&](std::size_t agent) { return static_cast<float>(seconds - tracks->people().presence(agent).first); });
      }
      break;
    default:
      values_.clear();
  }
}

void CrowdMeasures::take_densities(const Crowd& crowd, float cut_off, Executor& executor, int jobs) {
  const FollowedTracks* const tracks = crowd.tracks();
  const std::shared_ptr<const Trajectories> file = tracks != nullptr ? tracks->people().file() : nullptr;
  if (file != area_of_) {
    area_ = file != nullptr ? WalkableArea(file->plan) : WalkableArea();
    area_of_ = file;
  }
  density_.measure({crowd.positions(), absent_of(crowd)}, cut_off, area_, executor, jobs, values_);
}

}  // namespace throng::app
