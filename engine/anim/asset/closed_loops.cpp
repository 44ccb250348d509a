#include "engine/anim/asset/closed_loops.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace throng::anim {
namespace {

/// The keys of a track as they lie in memory: `width` values a key.
template <typename Value>
struct KeyList {
  std::vector<float>& times;
  std::vector<Value>& values;
  std::size_t width;

  void repeat(std::size_t key, float time) {
    const std::vector<Value> again(values.begin() + static_cast<std::ptrdiff_t>(key * width),
                                   values.begin() + static_cast<std::ptrdiff_t>((key + 1) * width));
    values.insert(values.end(), again.begin(), again.end());
    times.push_back(time);
  }
};

/// A track that ends before the others stands still up to the clip's last key.
template <typename Value>
void close(KeyList<Value> keys, float last, float closing) {
  if (keys.times.empty()) return;
  const std::size_t count = keys.times.size();
  if (keys.times.back() < last) keys.repeat(count - 1, last);
  if (keys.times.back() < closing) keys.repeat(0, closing);
}

template <typename Value>
void close(Track<Value>& track, float last, float closing) {
  close(KeyList<Value>{track.times, track.values, values_a_key(track.interpolation)}, last, closing);
}

}  // namespace

void close_loop(Clip& clip, double step) {
  const auto last = static_cast<float>(clip.duration);
  const auto closing = static_cast<float>(clip.duration + step);
  for (BoneTracks& tracks : clip.tracks) {
    close(tracks.translation, last, closing);
    close(tracks.rotation, last, closing);
    close(tracks.scale, last, closing);
  }
  for (MorphTrack& track : clip.morph_tracks) {
    const std::size_t width = track.morphs.size() * values_a_key(track.interpolation);
    close(KeyList<float>{track.times, track.weights, width}, last, closing);
  }
  for (NamedCurve& curve : clip.curves) close(KeyList<float>{curve.times, curve.values, 1}, last, closing);
  clip.duration = static_cast<double>(closing);
}

}  // namespace throng::anim
