#include "app/show/path_in_view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

constexpr std::uint32_t walked = 0xFF35B8FF, to_come = 0x7035B8FF;  // amber
constexpr float over_ground = 0.03F;                                // metres: paving does not cover it
constexpr float between_points = 0.1F;                              // metres
constexpr double between_looks = 0.1, most_looks = 200'000.0;       // seconds; looks in all

}  // namespace

void PathInView::add(SceneLines& lines, const Stage& stage) {
  const FollowedTracks* const tracks = stage.crowd().tracks();
  if (tracks == nullptr || !stage.selected()) return;
  const bool is_known = crowd_ == stage.animated().number() && agent_ == stage.selected();
  if (!is_known || tracks->people().trajectories().is_live) {
    crowd_ = stage.animated().number();
    agent_ = *stage.selected();
    find(tracks->people(), agent_);
  }
  const double now = tracks->clock().seconds;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Point &from = points_[i], &to = points_[i + 1];
    if (now <= from.seconds || now >= to.seconds) {
      lines.push_back({from.place, to.place, now >= to.seconds ? walked : to_come});
      continue;
    }
    const glm::vec3 here = tracks->people().position(agent_, now) + glm::vec3(0.0F, over_ground, 0.0F);
    lines.push_back({from.place, here, walked});
    lines.push_back({here, to.place, to_come});
  }
}

void PathInView::find(const Followers& followers, std::uint32_t agent) {
  points_.clear();
  const Presence& presence = followers.presence(agent);
  if (!std::isfinite(presence.first)) return;  // the person has not come yet
  const double length = presence.last - presence.first;
  const double looks = std::clamp(std::ceil(length / between_looks), 1.0, most_looks);
  for (double look = 0.0; look <= looks; ++look) {
    const double seconds = presence.first + length * look / looks;
    const Point point{followers.position(agent, seconds) + glm::vec3(0.0F, over_ground, 0.0F), seconds};
    const bool is_end = look == 0.0 || look == looks;
    if (is_end || glm::distance(point.place, points_.back().place) >= between_points) points_.push_back(point);
  }
  while (points_.size() > most_points) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); i += 2) points_[kept++] = points_[i];
    points_[kept++] = points_.back();
    points_.resize(kept);
  }
}

}  // namespace throng::app
