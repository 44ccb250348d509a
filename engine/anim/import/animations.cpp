#include "engine/anim/import/animations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

#include "engine/anim/import/accessors.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using anim::Interpolation;
using anim::Track;

/// The keys of a sampler, before their property is known.
struct Keys {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;
};

std::string key_at(std::size_t key, float seconds) {
  return "key " + std::to_string(key) + " is at " + std::to_string(seconds) + " s";
}

class AnimationReader {
 public:
  AnimationReader(Document& document, const NodeTree& tree, std::size_t index)
      : document_(document),
        tree_(tree),
        source_(document.gltf.animations[index]),
        data_keys_(document.data_keys[index]),
        name_(label("animation", index, source_.name)) {}

  Animation read() {
    animation_.name = source_.name;
    for (std::size_t channel = 0; channel < source_.channels.size(); ++channel) {
      channel_name_ = name_ + ", channel " + std::to_string(channel);
      read_channel(source_.channels[channel]);
    }
    animation_.start = std::min(start_, animation_.duration);
    read_data_keys();
    if (moves_shapes_) {
      document_.repairs.push_back(name_ + ": its morph weights are left out, shapes keep their default weights");
    }
    return std::move(animation_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { import::refuse(channel_name_, what); }

  void read_channel(const tinygltf::AnimationChannel& channel) {
    if (channel.sampler < 0 || static_cast<std::size_t>(channel.sampler) >= source_.samplers.size()) {
      refuse("there is no sampler " + std::to_string(channel.sampler));
    }
    if (channel.target_node < 0) return;  // glTF 2.0, 3.11: ignored
    if (!targets_.emplace(channel.target_node, channel.target_path).second) {
      refuse("a second channel for the " + channel.target_path + " of node " + std::to_string(channel.target_node));
    }
    const auto& sampler = source_.samplers[static_cast<std::size_t>(channel.sampler)];
    const Keys keys = read_keys(sampler);
    // A single key holds at all times, so it does not say when the clip begins.
    if (keys.times.size() > 1) start_ = std::min(start_, static_cast<double>(keys.times.front()));
    animation_.duration = std::max(animation_.duration, static_cast<double>(keys.times.back()));
    if (tree_.transforms[static_cast<std::size_t>(channel.target_node)].has_matrix) {
      document_.repairs.push_back(channel_name_ + ": ignored, because its node has a matrix");
      return;
    }
    read_values(channel, sampler.output, keys);
  }

  void read_values(const tinygltf::AnimationChannel& channel, int output, const Keys& keys) {
    NodeTracks& tracks = animation_.nodes[channel.target_node];
    if (channel.target_path == "translation") {
      tracks.translation = read_track<glm::vec3>(output, keys, TINYGLTF_TYPE_VEC3);
    } else if (channel.target_path == "scale") {
      tracks.scale = read_track<glm::vec3>(output, keys, TINYGLTF_TYPE_VEC3);
    } else if (channel.target_path == "rotation") {
      tracks.rotation = read_track<glm::quat>(output, keys, TINYGLTF_TYPE_VEC4);
      mend_rotations(tracks.rotation);
    } else {
      moves_shapes_ = true;
    }
  }

  /// Marks are set at frames and keys at 32-bit seconds, so a mark off by less than a millisecond means the end. A mark
  /// before the first key belongs to the pose that holds there, which plays from the first key on.
  void read_data_keys() {
    constexpr double rounding = 1e-3;
    for (const anim::NamedDataKey& key : data_keys_) {
      if (key.name.empty()) throw Refusal(name_ + ": a data key has no name; give it one");
      const std::string mark = name_ + ": data key \"" + key.name + "\" at " + std::to_string(key.time) + " s lies ";
      if (key.time < 0.0 || key.time > animation_.duration + rounding) {
        document_.repairs.push_back(mark + "outside of the animation, left out");
        continue;
      }
      if (key.time < animation_.start - rounding) {
        document_.repairs.push_back(mark + "before the first key, moved there");
      }
      const double time = std::clamp(key.time, animation_.start, animation_.duration);
      animation_.data_keys.push_back({.time = time, .name = key.name});
    }
    std::ranges::stable_sort(animation_.data_keys, {}, &anim::NamedDataKey::time);
  }

  Keys read_keys(const tinygltf::AnimationSampler& sampler) const {
    const std::string& mode = sampler.interpolation;
    Keys keys;
    if (mode == "STEP") {
      keys.interpolation = Interpolation::step;
    } else if (mode == "CUBICSPLINE") {
      keys.interpolation = Interpolation::cubic_spline;
    }
    keys.times =
        read_floats(document_, sampler.input, {channel_name_ + ": key times", {TINYGLTF_TYPE_SCALAR}, float_alone});
    check_times(keys.times, accessor_at(document_, sampler.input));
    return keys;
  }

  void check_times(const std::vector<float>& times, const tinygltf::Accessor& accessor) const {
    for (std::size_t key = 0; key < times.size(); ++key) {
      if (!std::isfinite(times[key]) || times[key] < 0.0F) refuse(key_at(key, times[key]) + ", which is no time");
      if (key > 0 && !(times[key] > times[key - 1])) refuse(key_at(key, times[key]) + ", not after the one before");
    }
    const auto lies = [](const std::vector<double>& bound, float actual) {
      const auto value = static_cast<double>(actual);
      return !bound.empty() && std::abs(bound.front() - value) > 1e-3 * std::max(1.0, std::abs(value));
    };
    if (lies(accessor.maxValues, times.back()) || lies(accessor.minValues, times.front())) {
      refuse("its key times do not lie between the min and max that their accessor says");
    }
  }

  /// Reads the values of the keys, three a key with tangents.
  template <typename Value>
  Track<Value> read_track(int output, const Keys& keys, int type) const {
    const auto values = read_floats(document_, output, {channel_name_ + ": key values", {type}, float_or_small});
    Track<Value> track{.interpolation = keys.interpolation, .times = keys.times, .values = grouped<Value>(values)};
    const std::size_t a_key = keys.interpolation == Interpolation::cubic_spline ? 3 : 1;
    if (track.values.size() != keys.times.size() * a_key) {
      refuse("has " + std::to_string(track.values.size()) + " values for " + std::to_string(keys.times.size()) +
             " key times");
    }
    if (!all_finite(values)) refuse("a key value is not finite");
    return track;
  }

  void mend_rotations(Track<glm::quat>& track) {
    const bool cubic = track.interpolation == Interpolation::cubic_spline;
    bool zero = false;
    bool long_keys = false;
    for (std::size_t i = cubic ? 1 : 0; i < track.values.size(); i += cubic ? 3 : 1) {
      const float length = glm::length(track.values[i]);
      long_keys = long_keys || std::abs(length - 1.0F) > 0.02F;  // more than 8-bit keys are off by
      if (length > 0.0F) continue;
      zero = true;
      track.values[i] = glm::quat(1.0F, 0.0F, 0.0F, 0.0F);
    }
    if (zero) document_.repairs.push_back(channel_name_ + ": zero rotation keys became the identity");
    if (long_keys) document_.repairs.push_back(channel_name_ + ": rotation keys of other than unit length, normalised");
  }

  Document& document_;
  const NodeTree& tree_;
  const tinygltf::Animation& source_;
  const std::vector<anim::NamedDataKey>& data_keys_;
  std::string name_;
  std::string channel_name_;
  std::set<std::pair<int, std::string>> targets_;
  bool moves_shapes_ = false;  // has a channel of morph weights
  Animation animation_;
  double start_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<Animation> read_animations(Document& document, const NodeTree& tree) {
  std::vector<Animation> animations;
  for (std::size_t index = 0; index < document.gltf.animations.size(); ++index) {
    animations.push_back(AnimationReader(document, tree, index).read());
  }
  return animations;
}

}  // namespace throng::import
