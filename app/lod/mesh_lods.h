#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/character/source.h"
#include "app/settings/settings.h"

namespace throng::app {

/// The share of Tuning::error_px that a coarser mesh may show. Poses may show the rest.
inline constexpr float mesh_share_of_error = 0.5F;

/// Returns the limit on the errors of poses alone.
float pose_error_limit(const Tuning& tuning);
/// Returns the limit on the errors of meshes alone, where a mesh is chosen by its error.
float mesh_error_limit(const Tuning& tuning);

/// Chooses the mesh LOD of each agent by the error that it shows on screen. A mesh LOD depends on no bone level.
class MeshLods {
 public:
  explicit MeshLods(std::span<const CharacterSource> characters) : shares_(characters.size()) {}

  /// Takes the errors of a character's mesh LODs, the full mesh first, in shares of the character's height.
  void set(std::size_t character, std::vector<float> shares) { shares_[character] = std::move(shares); }
  /// Allows `times` the error, where a processor draws. 1 at first.
  void allow_more(float times) { times_allowed_ = times; }

  /// Returns the coarsest LOD within the limit for a character of that height on screen, or the one that the tuning
  /// fixes. 0 for a character without LODs.
  int choose(const Tuning& tuning, std::uint8_t character, float pixels_tall) const;
  /// Returns the pixels that the surface of a LOD is off.
  float error_px(std::uint8_t character, int lod, float pixels_tall) const;

 private:
  std::vector<std::vector<float>> shares_;  // [character][LOD]
  float times_allowed_ = 1.0F;
};

}  // namespace throng::app
