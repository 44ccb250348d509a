#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/people/crowd/cast.h"
#include "app/people/crowd/lanes.h"
#include "app/people/crowd/layout.h"
#include "app/people/crowd/minds.h"
#include "app/people/crowd/steering/steering.h"

namespace throng::app {

/// Moves the agents that walk where they like, the first of a crowd. Each follows a point a few steps ahead on its
/// lane, at the speed of the gait that it has in mind, and makes way for others. It cuts across to a lane that it
/// changes to. A companion goes beside its leader instead, which waits for it, and stops where the leader does.
class CrowdWalkers {
 public:
  /// `bodies` has all agents, walkers first; `paces` has the walkers' speeds over the speed of the gait's clip. `cast`
  /// outlives this object, `obstacles` does not.
  CrowdWalkers(const CrowdCast& cast, std::vector<Lane> lanes, std::vector<WalkerStart> starts,
               std::vector<Body> bodies, std::vector<float> paces, Company company = {},
               std::span<const Obstacle> obstacles = {});

  /// Moves all walkers by `dt`, in steps short enough to steer by, then asks `minds` for the gait that fits the speed.
  /// Allocates nothing. The result does not depend on `jobs`.
  void advance(Ticks dt, Ticks now, CrowdMinds& minds, Executor& executor, int jobs);

  std::size_t count() const { return starts_.size(); }
  std::span<const Lane> lanes() const { return lanes_; }
  std::span<const Body> bodies() const { return bodies_; }         ///< [agent]
  std::span<const Heading> headings() const { return headings_; }  ///< [walker]
  /// Returns the metres a second of the walker in `gait` when no agent is in its way.
  float speed_of(std::size_t walker, Role gait) const;

 private:
  void begin_walking(std::size_t walker);
  void set_out(std::size_t walker, Random& whim);
  void turn_aside(std::size_t walker, Random& whim);
  void look_ahead(std::size_t walker);
  void wish_together(std::size_t leader, const CrowdMinds& minds);
  void wish(std::size_t walker, Role intention);
  void keep_company(std::size_t walker);
  glm::vec2 place_beside(std::size_t walker) const;
  glm::vec2 way_beside(std::size_t walker) const;
  float patient_speed(std::size_t leader, float speed) const;
  void stop(std::size_t walker);
  void turn(std::size_t walker, glm::vec2 most);
  Role gait(std::size_t walker, Role shown) const;
  Role next_gait(std::size_t walker, Ticks now, CrowdMinds& minds);
  void show_gaits(Ticks now, CrowdMinds& minds, Executor& executor, int jobs);

  const CrowdCast* cast_;
  float spacing_;
  std::vector<Lane> lanes_;
  std::vector<WalkerStart> starts_;  // the lane and the place of the point that the walker follows
  std::vector<glm::vec2> ahead_;     // that point
  std::vector<float> paces_;
  Company company_;
  std::vector<Heading> headings_;
  std::vector<Ticks> moved_at_;     // the time at which it last got on
  std::vector<Ticks> new_gait_at_;  // the time at which it last changed gait
  std::vector<Body> bodies_;
  std::vector<Wish> wishes_;
  std::vector<Role> next_gaits_;  // [walker] the gait that it goes over to in this frame; Role::other: it does not
  Steering steering_;
};

}  // namespace throng::app
