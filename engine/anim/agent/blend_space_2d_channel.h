#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/anim/agent/blend_plane.h"
#include "engine/anim/agent/blend_space_channel.h"

namespace throng::anim {

/// A clip, and the place in the plane at which it is played alone.
struct BlendPoint2d {
  int clip = 0;
  glm::vec2 place{0.0F};
  Pace pace = Pace::automatic;

  friend bool operator==(const BlendPoint2d&, const BlendPoint2d&) = default;
};

/// The points of a blend space in a plane, which any number of agents share.
class BlendSpace2d {
 public:
  /// `clip_count` is the character's. Errors: those of BlendPlane::create; a point plays an absent clip.
  static Result<std::shared_ptr<const BlendSpace2d>> create(std::vector<BlendPoint2d> points, PlaneMeaning meaning,
                                                            int clip_count);

  const BlendPoint2d& point(std::size_t index) const { return points_[index]; }
  std::span<const BlendPoint2d> all() const { return points_; }
  PlaneMeaning meaning() const { return meaning_; }
  const BlendPlane& plane() const { return plane_; }

 private:
  BlendSpace2d(std::vector<BlendPoint2d> points, PlaneMeaning meaning, BlendPlane plane)
      : points_(std::move(points)), meaning_(meaning), plane_(std::move(plane)) {}

  std::vector<BlendPoint2d> points_;
  PlaneMeaning meaning_;
  BlendPlane plane_;
};

/// Plays looping clips by two parameters, such as a velocity aside and ahead, or speed and turn. It mixes the corners
/// of the triangle that holds the place, at most three; a place outside of all triangles is moved to the nearest in
/// them. Gaits keep step and others play at their own rate, as in BlendSpaceChannel. The root moves at the requested
/// speed, also outside of the triangles.
class BlendSpace2dChannel final : public Channel {
 public:
  /// `space` is not null.
  BlendSpace2dChannel(std::shared_ptr<const BlendSpace2d> space, const glm::vec2& place);

  /// Sets both parameters at once, from the next update on. A place that is not finite changes nothing.
  void set_place(const glm::vec2& place);
  const glm::vec2& place() const { return place_; }
  /// Returns the phase of the gait that leads at the clock, 0 to below 1; 0 where no gait plays.
  double phase(const EntityBuilder& build) const { return players_.phase(build); }

  const char* fault(const EntityBuilder& build) const override;
  Handle state() const override { return players_.state(); }
  bool update(const EntityBuilder& build) override;
  bool update_in_place(const EntityBuilder& build) override;
  Ticks next_update() const override { return players_.next_update(); }
  void visit_handles(const std::function<void(Handle&)>& visit) override { players_.visit_handles(visit); }
  void destroy_entities(const EntityBuilder& build) override { players_.destroy_entities(build); }
  std::unique_ptr<Channel> clone() const override { return std::make_unique<BlendSpace2dChannel>(*this); }

 private:
  bool is_gait(const EntityBuilder& build, const BlendPoint2d& point) const;
  PlayingPoints shown(const EntityBuilder& build) const;
  double cycles_per_second(const EntityBuilder& build, std::span<const PlayingPoint> playing) const;

  std::shared_ptr<const BlendSpace2d> space_;
  glm::vec2 place_{0.0F};
  InStepPlayers players_;
};

}  // namespace throng::anim
