#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "app/character/source.h"
#include "app/crowd/crowd.h"
#include "app/settings/settings.h"
#include "engine/anim/asset/reference_pose.h"

namespace throng::app::test {

/// When a palette was evaluated, and the time that it is the pose of. What an agent is asked for in between does not
/// show in it.
struct PoseMoment {
  anim::Ticks evaluated = 0;
  anim::Ticks time = 0;  ///< from `evaluated` on
  /// On the way to a coarser level: the bones that it lacks are so far on their way to where they stand still, 0 to 1.
  std::size_t fade_level = 0;
  double faded = 0.0;
};

/// Where the surface of each agent belongs, in double, from the definitions alone: a crowd of its own says who is asked
/// for what and stands where, and poses come from the file's clips. No stream, kernel, player, schedule or slot.
class ReferenceCrowd {
 public:
  /// `character` must outlive it.
  ReferenceCrowd(const CharacterSource& character, const Tuning& tuning);

  void advance(anim::Ticks delta);

  anim::Ticks clock() const { return clock_; }
  bool fades(std::uint32_t agent) const;

  /// Every vertex of the surface at a bone level, model space, in the order of Model::meshes.
  std::vector<glm::dvec3> surface(std::uint32_t agent, const PoseMoment& moment, std::size_t level) const;
  std::vector<glm::dmat4> palette(std::uint32_t agent, const PoseMoment& moment) const;
  /// The same vertices under any palette.
  std::vector<glm::dvec3> surface_of(const std::vector<glm::dmat4>& palette, std::size_t level) const;
  glm::dvec3 to_world(std::uint32_t agent, const glm::dvec3& position) const;
  double scale(std::uint32_t agent) const { return static_cast<double>(crowd_.scales()[agent]); }

 private:
  /// A stretch of play at one speed.
  struct Stretch {
    anim::Ticks since = 0;
    double position = 0.0;  ///< seconds of the clip, then; loops not taken off
    double speed = 1.0;
  };
  struct Play {
    anim::Ticks asked = 0;
    std::size_t clip = 0;
    anim::Ticks fade = 0;
    std::vector<Stretch> stretches;  // oldest first; never empty
  };

  double speed_of(std::uint32_t agent) const;
  void keep_pace(std::uint32_t agent);
  std::vector<anim::StateTransform> locals_of(const Play& play, const PoseMoment& moment) const;

  const CharacterSource& character_;
  Crowd crowd_;
  anim::Ticks clock_ = 0;
  std::vector<std::vector<Play>> plays_;  // by agent, oldest first
};

}  // namespace throng::app::test
