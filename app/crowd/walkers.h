#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/crowd/cast.h"
#include "app/crowd/lanes.h"
#include "app/crowd/layout.h"
#include "app/crowd/minds.h"
#include "app/crowd/steering.h"

namespace throng::app {

/// The agents that walk where they like: the first of a crowd. Each follows a point that stays a few steps ahead on its
/// lane, at the speed of what it has in mind, and makes way for others; on another lane, it cuts across to it.
class CrowdWalkers {
 public:
  /// `bodies`: those of all agents, walkers first; `paces`: of the walkers, their speed over that of the gait's clip.
  /// `cast` outlives it.
  CrowdWalkers(const CrowdCast& cast, std::vector<Lane> lanes, std::vector<WalkerStart> starts,
               std::vector<Body> bodies, std::vector<float> paces);

  /// One frame of `dt`, in steps short enough to steer by; then asks `minds` for the gait that fits the speed.
  /// Allocates nothing. As Steering::step, the result does not depend on `jobs`.
  void advance(anim::Ticks dt, anim::Ticks now, CrowdMinds& minds, anim::Executor& executor, int jobs);

  std::size_t count() const { return starts_.size(); }
  std::span<const Lane> lanes() const { return lanes_; }
  std::span<const Body> bodies() const { return bodies_; }         ///< of all agents
  std::span<const Heading> headings() const { return headings_; }  ///< of the walkers
  /// Metres a second of the agent in `gait` when nobody is in its way.
  float speed_of(std::size_t walker, Role gait) const;

 private:
  void begin_walking(std::size_t walker);
  void set_out(std::size_t walker, Random& whim);
  void turn_aside(std::size_t walker, Random& whim);
  void look_ahead(std::size_t walker);
  void wish(std::size_t walker, Role intention);
  void stop(std::size_t walker);
  void turn(std::size_t walker, float seconds);
  Role gait(std::size_t walker, Role shown) const;
  void show_gait(std::size_t walker, anim::Ticks now, CrowdMinds& minds);

  const CrowdCast* cast_;
  float spacing_;
  std::vector<Lane> lanes_;
  std::vector<WalkerStart> starts_;  // where on which lane the point is that the walker follows
  std::vector<glm::vec2> ahead_;     // that point
  std::vector<float> paces_;
  std::vector<Heading> headings_;
  std::vector<anim::Ticks> moved_at_;     // when it last got on
  std::vector<anim::Ticks> new_gait_at_;  // when it last changed gait
  std::vector<Body> bodies_;
  std::vector<Wish> wishes_;
  Steering steering_;
};

}  // namespace throng::app
