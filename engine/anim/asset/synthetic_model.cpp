#include "engine/anim/asset/synthetic_model.h"

#include <cassert>
#include <numbers>
#include <random>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/base/elementary.h"

namespace throng::anim {

namespace {

/// Lists joints by importance: a smaller skeleton is the start of the list, a larger one grows more strands.
class Body {
 public:
  explicit Body(int bones) : wanted_(static_cast<std::size_t>(bones)) {
    const int hips = chain(-1, "hips", 1, {0.0F, 1.0F, 0.0F}, {});
    const int chest = chain(hips, "spine", 3, {0.0F, 0.14F, 0.0F}, {0.0F, 0.14F, 0.0F});
    for (const float side : {1.0F, -1.0F}) chain(hips, "leg", 4, {side * 0.1F, -0.1F, 0.0F}, {0.0F, -0.42F, 0.03F});
    chain(chest, "head", 2, {0.0F, 0.16F, 0.0F}, {0.0F, 0.1F, 0.02F});
    for (const float side : {1.0F, -1.0F}) hands_[side < 0.0F ? 1 : 0] = arm(chest, side);
    for (int finger = 0; finger < 5; ++finger) {
      for (const int hand : hands_) fingers(hand, finger);
    }
    for (int strand = 0; parents.size() < wanted_; ++strand) {
      chain(strand % 6, "strand", 4, {0.0F, 0.02F, -0.1F}, {0.0F, -0.05F, -0.05F});
    }
  }

  std::vector<int> parents;
  std::vector<std::string> names;
  std::vector<glm::vec3> offsets;  ///< from the parent, in the parent's space

 private:
  /// Adds `count` joints, each below the one before; returns the last, or `parent` once the skeleton is full.
  int chain(int parent, const std::string& name, int count, glm::vec3 first, glm::vec3 next) {
    for (int i = 0; i < count && parents.size() < wanted_; ++i) {
      names.push_back(name + "_" + std::to_string(names.size()));
      offsets.push_back(i == 0 ? first : next);
      parents.push_back(parent);
      parent = static_cast<int>(parents.size()) - 1;
    }
    return parent;
  }
  int arm(int chest, float side) {
    const int shoulder = chain(chest, "shoulder", 1, {side * 0.06F, 0.1F, 0.0F}, {});
    return chain(shoulder, "arm", 3, {side * 0.12F, 0.0F, 0.0F}, {side * 0.27F, 0.0F, 0.0F});
  }
  void fingers(int hand, int finger) {
    const float side = hand == hands_[0] ? 1.0F : -1.0F;
    const float across = 0.02F * static_cast<float>(finger - 2);
    chain(hand, "finger", 4, {side * 0.09F, 0.0F, across}, {side * 0.03F, 0.0F, 0.0F});
  }

  std::size_t wanted_;
  int hands_[2] = {0, 0};
};

/// Gives the same numbers for a seed on every machine, which std::uniform_real_distribution does not promise.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float between(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() >> 8U) / static_cast<float>(1U << 24U);
  }
  glm::vec3 axis() {
    // One statement each: the order in which a compiler computes arguments is its own.
    const float z = between(0.1F, 1.0F);
    const float y = between(-1.0F, 1.0F);
    const float x = between(-1.0F, 1.0F);
    return glm::normalize(glm::vec3(x, y, z));
  }

 private:
  std::mt19937 engine_;
};

Skeleton skeleton_of(const Body& body, Random& random) {
  std::vector<double> lengths;
  for (const glm::vec3& offset : body.offsets) lengths.push_back(static_cast<double>(glm::length(offset)));
  const BoneOrder order = order_bones(body.parents, lengths);
  std::vector<int> place(order.bones.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[static_cast<std::size_t>(order.bones[i])] = static_cast<int>(i);

  Skeleton skeleton;
  skeleton.name = "synthetic";
  skeleton.level_bone_counts = order.level_counts;
  for (const int joint : order.bones) {
    const auto j = static_cast<std::size_t>(joint);
    const int parent = body.parents[j] < 0 ? -1 : place[static_cast<std::size_t>(body.parents[j])];
    const glm::vec3 axis = random.axis();
    const glm::quat turned = angle_axis(random.between(-0.4F, 0.4F), axis);
    skeleton.bones.push_back(
        {.name = body.names[j], .node = joint, .parent = parent, .rest = {body.offsets[j], turned, glm::vec3(1.0F)}});
  }
  return skeleton;
}

/// Makes the rest pose the bind pose.
void bind(Skeleton& skeleton) {
  for (const Bone& bone : skeleton.bones) {
    const ReferenceFrame parent =
        bone.parent < 0 ? ReferenceFrame{} : skeleton.references[static_cast<std::size_t>(bone.parent)];
    const glm::dquat rotation = glm::normalize(parent.rotation * glm::dquat(bone.rest.rotation));
    const glm::dvec3 origin = parent.origin + parent.rotation * glm::dvec3(bone.rest.translation);
    const glm::dmat4 global = glm::translate(glm::dmat4(1.0), origin) * glm::mat4_cast(rotation);
    skeleton.palette.push_back({.bone = static_cast<int>(skeleton.references.size()), .post = glm::inverse(global)});
    skeleton.references.push_back({.rotation = rotation, .origin = origin});
  }
}

Skin skin_of(const Skeleton& skeleton) {
  Skin skin;
  skin.skin = 0;
  skin.name = skeleton.name;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    skin.bones.push_back(bone);
    skin.palette_entries.push_back(bone);
    skin.inverse_binds.push_back(skeleton.palette[static_cast<std::size_t>(bone)].post);
  }
  return skin;
}

/// Returns a value of a whole number of swings, so that the last key repeats the first to the bit.
float swing(int frame, int frames, float phase) {
  const float turn = static_cast<float>(frame % frames) / static_cast<float>(frames) + phase;
  return sine(2.0F * std::numbers::pi_v<float> * turn);
}

BoneTracks turning_bone(const Skeleton& skeleton, int bone, const std::vector<float>& times, Random& random) {
  const int frames = static_cast<int>(times.size()) - 1;
  const glm::vec3 axis = random.axis();
  const float reach = random.between(0.05F, 0.35F);
  const float phase = random.between(0.0F, 1.0F);
  const glm::quat rest = skeleton.bones[static_cast<std::size_t>(bone)].rest.rotation;
  BoneTracks tracks;
  tracks.bone = bone;
  tracks.rotation.times = times;
  for (int frame = 0; frame <= frames; ++frame) {
    tracks.rotation.values.push_back(rest * angle_axis(reach * swing(frame, frames, phase), axis));
  }
  return tracks;
}

// Makes a clip a little shorter or longer than a second.
Clip clip_of(const Skeleton& skeleton, int index, int keys_per_second, Random& random) {
  const int frames = keys_per_second + (index % 7 - 3) * keys_per_second / 30;
  std::vector<float> times;
  for (int frame = 0; frame <= frames; ++frame)
    times.push_back(static_cast<float>(frame) / static_cast<float>(keys_per_second));

  Clip clip;
  clip.name = "clip_" + std::to_string(index);
  clip.animation = index;
  clip.duration = static_cast<double>(times.back());
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    clip.tracks.push_back(turning_bone(skeleton, bone, times, random));
  }
  Track<glm::vec3>& root = clip.tracks.front().translation;
  root.times = times;
  const float phase = random.between(0.0F, 1.0F);
  for (int frame = 0; frame <= frames; ++frame) {
    const glm::vec3 sway(0.02F * swing(frame, frames, phase), 0.015F * swing(frame, frames, phase + 0.25F), 0.0F);
    root.values.push_back(skeleton.bones.front().rest.translation + sway);
  }
  return clip;
}

}  // namespace

Model synthetic_model(int bones, int clips, unsigned seed, int keys_per_second) {
  assert(bones >= 1 && bones <= max_bones && clips >= 1 && keys_per_second >= 8);
  Random random(seed);
  Model model;
  model.skeleton = skeleton_of(Body(bones), random);
  bind(model.skeleton);
  model.skins.push_back(skin_of(model.skeleton));
  for (int clip = 0; clip < clips; ++clip)
    model.clips.push_back(clip_of(model.skeleton, clip, keys_per_second, random));
  return model;
}

}  // namespace throng::anim
