#include "engine/anim/import/animations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/memory/model_memory.h"

namespace throng::import {

namespace {

using anim::Interpolation;
using anim::Track;

constexpr std::size_t bytes_a_channel = 512;  // beside its keys
constexpr float largest_weight = 1e4F;        // a larger one would move a surface out of sight

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
        curves_(document.curves[index]),
        name_(label("animation", index, source_.name)) {
    animation_.clip.animation = static_cast<int>(index);
  }

  Animation read() {
    animation_.clip.name = source_.name;
    for (std::size_t channel = 0; channel < source_.channels.size(); ++channel) {
      channel_name_ = name_ + ", channel " + std::to_string(channel);
      read_channel(source_.channels[channel]);
    }
    animation_.clip.start = std::min(start_, animation_.clip.duration);
    read_data_keys();
    check_curves();
    animation_.clip.curves = curves_;
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
    MemoryScope scope(*document_.memory);
    const auto& sampler = source_.samplers[static_cast<std::size_t>(channel.sampler)];
    const Keys keys = read_keys(sampler);
    // A single key holds at all times, so it does not say when the clip begins.
    if (keys.times.size() > 1) start_ = std::min(start_, static_cast<double>(keys.times.front()));
    double& duration = animation_.clip.duration;
    duration = std::max(duration, static_cast<double>(keys.times.back()));
    if (channel.target_path == "weights") return scope.keep(read_weights(channel.target_node, sampler.output, keys));
    if (tree_.transforms[static_cast<std::size_t>(channel.target_node)].has_matrix) {
      document_.repairs.push_back(channel_name_ + ": ignored, because its node has a matrix");
      return;
    }
    scope.keep(read_values(channel, sampler.output, keys));
  }

  /// Returns the bytes that it keeps.
  std::uint64_t read_values(const tinygltf::AnimationChannel& channel, int output, const Keys& keys) {
    anim::BoneTracks& tracks = animation_.nodes[channel.target_node];
    if (channel.target_path == "translation") {
      tracks.translation = read_track<glm::vec3>(output, keys, TINYGLTF_TYPE_VEC3);
      return bytes_of(tracks.translation);
    }
    if (channel.target_path == "scale") {
      tracks.scale = read_track<glm::vec3>(output, keys, TINYGLTF_TYPE_VEC3);
      return bytes_of(tracks.scale);
    }
    tracks.rotation = read_track<glm::quat>(output, keys, TINYGLTF_TYPE_VEC4);
    mend_rotations(tracks.rotation);
    return bytes_of(tracks.rotation);
  }

  /// Returns the number of morph targets of the node's mesh. All its primitives should have as many.
  std::size_t target_count(int node) const {
    const int mesh = document_.gltf.nodes[static_cast<std::size_t>(node)].mesh;
    std::size_t count = 0;
    if (mesh < 0) return count;
    for (const tinygltf::Primitive& primitive : document_.gltf.meshes[static_cast<std::size_t>(mesh)].primitives) {
      count = std::max(count, primitive.targets.size());
    }
    return count;
  }

  std::uint64_t read_weights(int node, int output, const Keys& keys) {
    document_.memory->charge(bytes_of(keys.times), channel_name_);
    WeightKeys read{
        .interpolation = keys.interpolation, .targets = target_count(node), .times = keys.times, .weights = {}};
    if (read.targets == 0) {
      document_.repairs.push_back(channel_name_ + ": weights of a node without morph targets, left out");
      return 0;
    }
    read.weights =
        read_floats(document_, output, {channel_name_ + ": key values", {TINYGLTF_TYPE_SCALAR}, float_or_small});
    const std::size_t expected = keys.times.size() * values_a_key(keys.interpolation) * read.targets;
    if (read.weights.size() != expected) {
      refuse("has " + std::to_string(read.weights.size()) + " weights for " + std::to_string(keys.times.size()) +
             " key times of " + std::to_string(read.targets) + " morph targets");
    }
    const auto is_sane = [](float weight) { return std::abs(weight) <= largest_weight; };  // no number is not
    if (!std::ranges::all_of(read.weights, is_sane))
      refuse("a weight of a morph target is no number, or beyond 10,000");
    const WeightKeys& kept = animation_.weights.emplace(node, std::move(read)).first->second;
    return bytes_of(kept.times) + bytes_of(kept.weights);
  }

  /// Marks are set at frames and keys at 32-bit seconds, so a mark off by less than a millisecond means the end. A mark
  /// before the first key belongs to the pose that holds there, which plays from the first key on.
  void read_data_keys() {
    constexpr double rounding = 1e-3;
    anim::Clip& clip = animation_.clip;
    for (const anim::NamedDataKey& key : data_keys_) {
      if (key.name.empty()) throw Refusal(name_ + ": a data key has no name; give it one");
      const std::string mark = name_ + ": data key \"" + key.name + "\" at " + std::to_string(key.time) + " s lies ";
      if (key.time < 0.0 || key.time > clip.duration + rounding) {
        document_.repairs.push_back(mark + "outside of the animation, left out");
        continue;
      }
      if (key.time < clip.start - rounding) {
        document_.repairs.push_back(mark + "before the first key, moved there");
      }
      const double time = std::clamp(key.time, clip.start, clip.duration);
      clip.data_keys.push_back({.time = time, .name = key.name});
    }
    std::ranges::stable_sort(clip.data_keys, {}, &anim::NamedDataKey::time);
  }

  void check_curves() const {
    std::set<std::string> names;
    for (const anim::NamedCurve& curve : curves_) {
      if (curve.name.empty()) throw Refusal(name_ + ": a curve has no name; give it one");
      const std::string named = name_ + ": curve \"" + curve.name + "\" ";
      if (!names.insert(curve.name).second) throw Refusal(named + "is there twice; give each a name of its own");
      if (curve.times.empty() || curve.times.size() != curve.values.size()) {
        throw Refusal(named + "has " + std::to_string(curve.values.size()) + " values for " +
                      std::to_string(curve.times.size()) + " times; give each time one value");
      }
      for (std::size_t key = 1; key < curve.times.size(); ++key) {
        if (curve.times[key] > curve.times[key - 1]) continue;
        throw Refusal(named + key_at(key, curve.times[key]) + ", not after the one before; sort its keys by time");
      }
    }
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
    document_.memory->charge(bytes_of(keys.times) + bytes_of(values), channel_name_);
    Track<Value> track{.interpolation = keys.interpolation, .times = keys.times, .values = grouped<Value>(values)};
    if (track.values.size() != keys.times.size() * values_a_key(keys.interpolation)) {
      refuse("has " + std::to_string(track.values.size()) + " values for " + std::to_string(keys.times.size()) +
             " key times");
    }
    if (!all_finite(values)) refuse("a key value is not finite");
    return track;
  }

  void mend_rotations(Track<glm::quat>& track) {
    const std::size_t step = values_a_key(track.interpolation);
    bool zero = false;
    bool long_keys = false;
    for (std::size_t i = step / 2; i < track.values.size(); i += step) {
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
  const std::vector<anim::NamedCurve>& curves_;
  std::string name_;
  std::string channel_name_;
  std::set<std::pair<int, std::string>> targets_;
  Animation animation_;
  double start_ = std::numeric_limits<double>::infinity();
};

/// Returns whether the row at `index` of WeightKeys::weights holds weights, not tangents.
bool is_weight(const WeightKeys& keys, std::size_t index) {
  return keys.interpolation != Interpolation::cubic_spline || index / keys.targets % 3 == 1;
}

double rest_weight(std::span<const double> rest_weights, std::size_t target) {
  return target < rest_weights.size() ? rest_weights[target] : 0.0;
}

/// Marks the targets that do not keep their own weight.
void mark_moving(const WeightKeys& keys, std::span<const double> rest_weights, std::vector<bool>& moving) {
  moving.resize(std::max(moving.size(), keys.targets), false);
  for (std::size_t i = 0; i < keys.weights.size(); ++i) {
    const std::size_t target = i % keys.targets;
    const double still = is_weight(keys, i) ? rest_weight(rest_weights, target) : 0.0;
    if (static_cast<float>(still) != keys.weights[i]) moving[target] = true;
  }
}

/// Returns the keys of the morphs that stand for targets of `node`, above the weights at rest.
anim::MorphTrack morph_track(const WeightKeys& keys, int node, const std::vector<anim::Morph>& morphs,
                             MemoryAccount& memory) {
  const std::string node_name = "node " + std::to_string(node) + ", the weights of its morph targets";
  anim::MorphTrack track{.interpolation = keys.interpolation, .morphs = {}, .times = {}, .weights = {}};
  for (std::size_t morph = 0; morph < morphs.size(); ++morph) {
    if (morphs[morph].node == node) track.morphs.push_back(static_cast<int>(morph));
  }
  const std::size_t rows = keys.weights.size() / keys.targets;
  memory.charge(bytes_of(keys.times) + rows * bytes_of(track.morphs), node_name);
  track.times = keys.times;
  track.weights.reserve(rows * track.morphs.size());
  for (std::size_t row = 0; row < keys.weights.size(); row += keys.targets) {
    for (const int index : track.morphs) {
      const anim::Morph& morph = morphs[static_cast<std::size_t>(index)];
      const float rest = is_weight(keys, row) ? static_cast<float>(morph.rest_weight) : 0.0F;
      track.weights.push_back(keys.weights[row + static_cast<std::size_t>(morph.target)] - rest);
    }
  }
  return track;
}

/// Returns the clip of an animation, which is made if there is none.
anim::Clip& clip_of(const std::vector<Animation>& animations, int index, std::vector<anim::Clip>& clips) {
  const auto place = std::ranges::lower_bound(clips, index, {}, &anim::Clip::animation);
  if (place != clips.end() && place->animation == index) return *place;
  return *clips.insert(place, animations[static_cast<std::size_t>(index)].clip);
}

}  // namespace

std::vector<int> animated_targets(const std::vector<Animation>& animations, int node,
                                  std::span<const double> rest_weights) {
  std::vector<bool> moving;
  for (const Animation& animation : animations) {
    const auto keys = animation.weights.find(node);
    if (keys != animation.weights.end()) mark_moving(keys->second, rest_weights, moving);
  }
  std::vector<int> targets;
  for (std::size_t target = 0; target < moving.size(); ++target) {
    if (moving[target]) targets.push_back(static_cast<int>(target));
  }
  return targets;
}

void add_morph_tracks(const std::vector<Animation>& animations, anim::Model& model, MemoryAccount& memory) {
  for (std::size_t index = 0; index < animations.size(); ++index) {
    for (const auto& [node, keys] : animations[index].weights) {
      anim::MorphTrack track = morph_track(keys, node, model.morphs, memory);
      if (track.morphs.empty()) continue;
      const anim::Clip& source = animations[index].clip;
      memory.charge(clip_memory(source), label("animation", index, source.name));
      clip_of(animations, static_cast<int>(index), model.clips).morph_tracks.push_back(std::move(track));
    }
  }
}

std::vector<Animation> read_animations(Document& document, const NodeTree& tree) {
  std::vector<Animation> animations;
  for (std::size_t index = 0; index < document.gltf.animations.size(); ++index) {
    const tinygltf::Animation& source = document.gltf.animations[index];
    document.memory->charge(source.channels.size() * bytes_a_channel, label("animation", index, source.name));
    animations.push_back(AnimationReader(document, tree, index).read());
  }
  return animations;
}

}  // namespace throng::import
