#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace throng::anim {

/// glTF 2.0, 3.11 "Animations" and appendix C.
enum class Interpolation : unsigned char { step, linear, cubic_spline };

constexpr std::size_t values_a_key(Interpolation interpolation) {
  return interpolation == Interpolation::cubic_spline ? 3 : 1;
}

/// The keys of one property of one bone as the file has them. Empty where the clip does not animate the property.
template <typename Value>
struct Track {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;   ///< seconds, strictly ascending, first >= 0, all finite
  std::vector<Value> values;  ///< values_a_key() a time; three: in-tangent, value, out-tangent

  bool empty() const { return times.empty(); }
};

struct BoneTracks {
  int bone = 0;
  Track<glm::vec3> translation;
  Track<glm::quat> rotation;  ///< as stored; may differ from unit length (normalised integers)
  Track<glm::vec3> scale;
};

/// The weights of morphs of one mesh, beyond the weights of its surface without animation. Keys hold as in Track.
struct MorphTrack {
  Interpolation interpolation = Interpolation::linear;
  std::vector<int> morphs;     ///< indices among Model::morphs, ascending
  std::vector<float> times;    ///< seconds, as in Track
  std::vector<float> weights;  ///< [key][morph]; with cubic_spline [key][in-tangent, weight, out-tangent][morph]
};

/// A named moment of a clip for game play (the paper's "data key", 2.2.2), as the file has it.
struct NamedDataKey {
  double time = 0.0;  ///< seconds of the file, from the clip's start to its duration
  std::string name;   ///< never empty
};

/// A number over the time of a clip, for game play, as the file has it: how closed an eye is, how hot a sword glows.
/// Between keys it is linear; before the first and after the last, the nearest holds.
struct NamedCurve {
  std::string name;           ///< never empty; no two of a clip are alike
  std::vector<float> times;   ///< seconds of the file, strictly ascending, at least one
  std::vector<float> values;  ///< one a time, finite
};

/// One animation of the file, restricted to one skeleton. A bone without a track keeps its rest transform. Before a
/// track's first key and after its last, the nearest key holds. Its times are the file's; a player of it begins at
/// `start`, since the time before the first key is no part of a loop.
struct Clip {
  std::string name;
  int animation = -1;     ///< index in the file
  double start = 0.0;     ///< seconds, the first key of all channels with two keys or more, other skeletons' too
  double duration = 0.0;  ///< seconds, the last key of all channels, other skeletons' too
  std::vector<BoneTracks> tracks;            ///< ascending by bone, at most one a bone
  std::vector<NamedDataKey> data_keys = {};  ///< by time
  std::vector<MorphTrack> morph_tracks = {};
  std::vector<NamedCurve> curves = {};  ///< no pose depends on them

  /// Returns the seconds that it plays, from its first key to its last.
  double length() const { return duration - start; }
};

/// Takes out the tracks of scales, since a rigid skeleton has no moving ones.
inline void drop_scales(Clip& clip) {
  for (BoneTracks& tracks : clip.tracks) tracks.scale = {};
  std::erase_if(clip.tracks,
                [](const BoneTracks& tracks) { return tracks.translation.empty() && tracks.rotation.empty(); });
}

}  // namespace throng::anim
