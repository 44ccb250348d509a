#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace throng::app {

/// What a member of the crowd can be doing.
enum class Role : std::uint8_t { idle, walk, cheer, wave, clap, other };
inline constexpr std::size_t role_count = 5;  ///< roles that one clip fills; `other` is whatever clip there is

inline constexpr int no_clip = -1;

/// Which clips of a character the crowd plays for what, and the body that it needs room for.
struct CharacterRoles {
  std::array<int, role_count> clips{no_clip, no_clip, no_clip, no_clip, no_clip};  ///< index or no_clip, by Role
  std::vector<int> others;  ///< what agents play in place, in turns, where there is no idle clip
  double walk_speed = 0.0;  ///< metres a second of the walk clip itself, at scale 1; 0: nobody walks
  double height = 1.8;      ///< metres
  double radius = 0.3;      ///< metres, of the body seen from above, arms down

  int clip(Role role) const { return clips[static_cast<std::size_t>(role)]; }
  /// How much more room it needs than a person 1.8 metres tall; every distance of a scene is multiplied by it.
  double spacing() const { return std::max(height / 1.8, radius / 0.5); }
  bool can_walk() const { return clip(Role::walk) != no_clip && walk_speed > 0.0; }
};

/// Guesses roles from clip names as artists write them: "Idle", "Walking_A", "CharacterArmature|Wave". The plainest
/// name wins; a run stands in for a walk. Fills `clips` and `others` and leaves the rest to the caller.
CharacterRoles roles_by_name(std::span<const std::string> clip_names);

}  // namespace throng::app
