#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "app/settings/settings.h"
#include "engine/anim/asset/reference_pose.h"

namespace throng::app::test {

/// The moment at which a palette was evaluated, and the moment whose pose it is. Requests that an agent gets in between
/// do not show in it.
struct PoseMoment {
  Ticks evaluated{};
  Ticks time{};  ///< `evaluated` or later
  /// The coarser level on the way. The bones that it lacks have come `faded`, 0 to 1, towards their rest.
  std::size_t fade_level = 0;
  double faded = 0.0;
};

/// Computes in double, from the definitions alone, where the surface of each agent belongs. A crowd of its own says
/// where agents are and what they are asked for, and poses come from the clips of the file. It uses no stream, kernel,
/// player, schedule or slot.
class ReferenceCrowd {
 public:
  /// `character` must outlive it; `clips` are those of its file.
  ReferenceCrowd(const CharacterSource& character, std::vector<anim::Clip> clips, const Tuning& tuning);

  void advance(Ticks delta);

  Ticks clock() const { return clock_; }
  bool fades(std::uint32_t agent) const;

  /// Gives every vertex of the surface at a bone level, in model space and in the order of Model::meshes.
  std::vector<glm::dvec3> surface(std::uint32_t agent, const PoseMoment& moment, std::size_t level) const;
  std::vector<glm::dmat4> palette(std::uint32_t agent, const PoseMoment& moment) const;
  /// Gives the same vertices, moved by any palette.
  std::vector<glm::dvec3> surface_of(const std::vector<glm::dmat4>& palette, std::size_t level) const;
  glm::dvec3 to_world(std::uint32_t agent, const glm::dvec3& position) const;
  double scale(std::uint32_t agent) const { return static_cast<double>(crowd_.scales()[agent]); }

 private:
  /// A time during which a clip plays at one speed.
  struct Stretch {
    Ticks since{};
    double position = 0.0;  ///< seconds into the clip at its start, loops included
    double speed = 1.0;
  };
  struct Play {
    Ticks asked{};
    std::size_t clip = 0;
    Ticks fade{};
    std::vector<Stretch> stretches;  // oldest first; never empty
  };

  double speed_of(std::uint32_t agent) const;
  void keep_pace(std::uint32_t agent);
  std::vector<anim::StateTransform> locals_of(const Play& play, const PoseMoment& moment) const;

  const CharacterSource& character_;
  std::vector<anim::Clip> clips_;
  Crowd crowd_;
  Ticks clock_{};
  std::vector<std::vector<Play>> plays_;  // [agent], oldest first
};

}  // namespace throng::app::test
