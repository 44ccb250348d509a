#include "tests/benchmark/programs/ozz_subject.h"

#ifdef THRONG_HAS_OZZ

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <ozz/animation/offline/animation_builder.h>
#include <ozz/animation/offline/raw_animation.h>
#include <ozz/animation/offline/raw_skeleton.h>
#include <ozz/animation/offline/skeleton_builder.h>
#include <ozz/animation/runtime/animation.h>
#include <ozz/animation/runtime/blending_job.h>
#include <ozz/animation/runtime/local_to_model_job.h>
#include <ozz/animation/runtime/sampling_job.h>
#include <ozz/animation/runtime/skeleton.h>
#include <ozz/base/maths/simd_math.h>
#include <ozz/base/maths/soa_transform.h>

namespace throng::app {
namespace {

using ozz::math::Float3;
using ozz::math::Float4x4;
using ozz::math::Quaternion;

constexpr anim::Ticks frame_step = anim::ticks_per_second / 60;

Float3 of(const glm::vec3& v) { return {v.x, v.y, v.z}; }
Quaternion of(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

bool is_plain(const anim::Model& model) {
  for (const anim::Bone& bone : model.skeleton.bones) {
    if (bone.prefix != glm::dmat4(1.0)) return false;
  }
  for (const anim::Clip& clip : model.clips) {
    for (const anim::BoneTracks& tracks : clip.tracks) {
      if (tracks.rotation.interpolation != anim::Interpolation::linear || !tracks.scale.empty()) return false;
    }
  }
  return model.skeleton.rigid && !model.clips.empty();
}

/// Joints are named after our bones, because ozz puts them in an order of its own.
ozz::animation::offline::RawSkeleton::Joint raw_joint(const anim::Skeleton& skeleton, int bone) {
  const auto index = static_cast<std::size_t>(bone);
  ozz::animation::offline::RawSkeleton::Joint joint;
  joint.name = std::to_string(bone).c_str();
  joint.transform.translation = of(skeleton.bones[index].rest.translation);
  joint.transform.rotation = of(skeleton.bones[index].rest.rotation);
  joint.transform.scale = of(skeleton.bones[index].rest.scale);
  for (int child = bone + 1; child < skeleton.bone_count(); ++child) {
    if (skeleton.bones[static_cast<std::size_t>(child)].parent == bone) {
      joint.children.push_back(raw_joint(skeleton, child));
    }
  }
  return joint;
}

ozz::animation::offline::RawSkeleton raw_skeleton(const anim::Skeleton& skeleton) {
  ozz::animation::offline::RawSkeleton raw;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    if (skeleton.bones[static_cast<std::size_t>(bone)].parent < 0) raw.roots.push_back(raw_joint(skeleton, bone));
  }
  return raw;
}

ozz::animation::offline::RawAnimation raw_animation(const anim::Skeleton& skeleton, const anim::Clip& clip,
                                                    const std::vector<std::size_t>& joint_of_bone) {
  ozz::animation::offline::RawAnimation raw;
  raw.duration = static_cast<float>(clip.duration);
  raw.tracks.resize(skeleton.bones.size());
  for (std::size_t bone = 0; bone < skeleton.bones.size(); ++bone) {
    auto& track = raw.tracks[joint_of_bone[bone]];
    track.translations.push_back({0.0F, of(skeleton.bones[bone].rest.translation)});
    track.rotations.push_back({0.0F, of(skeleton.bones[bone].rest.rotation)});
  }
  for (const anim::BoneTracks& tracks : clip.tracks) {
    auto& track = raw.tracks[joint_of_bone[static_cast<std::size_t>(tracks.bone)]];
    if (!tracks.rotation.empty()) track.rotations.clear();
    if (!tracks.translation.empty()) track.translations.clear();
    for (std::size_t key = 0; key < tracks.rotation.times.size(); ++key) {
      track.rotations.push_back({tracks.rotation.times[key], of(tracks.rotation.values[key])});
    }
    for (std::size_t key = 0; key < tracks.translation.times.size(); ++key) {
      track.translations.push_back({tracks.translation.times[key], of(tracks.translation.values[key])});
    }
  }
  return raw;
}

Float4x4 matrix_of(const glm::dmat4& matrix) {
  Float4x4 result;
  for (int column = 0; column < 4; ++column) {
    const glm::vec4 values(matrix[column]);
    result.cols[column] = ozz::math::simd_float4::LoadPtrU(&values.x);
  }
  return result;
}

class PlainOzzSubject final : public OzzSubject {
 public:
  PlainOzzSubject(std::span<const BenchAgent> agents, const BenchPalettes& palettes)
      : agents_(agents), palettes_(&palettes) {}

  bool build(const anim::Model& model) {
    const ozz::animation::offline::RawSkeleton raw = raw_skeleton(model.skeleton);
    if (!raw.Validate()) return false;
    skeleton_ = ozz::animation::offline::SkeletonBuilder()(raw);
    std::vector<std::size_t> joint_of_bone(model.skeleton.bones.size());
    for (int joint = 0; joint < skeleton_->num_joints(); ++joint) {
      const int bone = std::stoi(skeleton_->joint_names()[static_cast<std::size_t>(joint)]);
      joint_of_bone[static_cast<std::size_t>(bone)] = static_cast<std::size_t>(joint);
      entry_of_joint_.push_back(static_cast<std::size_t>(bone));
      inverse_binds_.push_back(matrix_of(model.skeleton.palette[static_cast<std::size_t>(bone)].post));
    }
    for (const anim::Clip& clip : model.clips) {
      const auto raw_clip = raw_animation(model.skeleton, clip, joint_of_bone);
      if (!raw_clip.Validate()) return false;
      clips_.push_back(ozz::animation::offline::AnimationBuilder()(raw_clip));
    }
    make_buffers();
    return true;
  }

  void run() override {
    clock_ += frame_step;
    for (std::size_t agent = 0; agent < agents_.size(); ++agent) pose(agent);
  }

 private:
  void make_buffers() {
    const auto soa = static_cast<std::size_t>(skeleton_->num_soa_joints());
    for (auto& locals : locals_) locals.resize(soa);
    blended_.resize(soa);
    models_.resize(static_cast<std::size_t>(skeleton_->num_joints()));
    for (std::size_t i = 0; i < 2 * agents_.size(); ++i) {
      contexts_.push_back(std::make_unique<ozz::animation::SamplingJob::Context>(skeleton_->num_joints()));
    }
  }

  void sample(std::size_t agent, std::size_t source, int clip, anim::Ticks start) {
    const ozz::animation::Animation& animation = *clips_[static_cast<std::size_t>(clip)];
    const anim::Ticks duration = anim::to_ticks(static_cast<double>(animation.duration()));
    ozz::animation::SamplingJob job;
    job.animation = &animation;
    job.context = contexts_[2 * agent + source].get();
    job.ratio = static_cast<float>(static_cast<double>((start + clock_) % duration) / static_cast<double>(duration));
    job.output = ozz::make_span(locals_[source]);
    job.Run();
  }

  void pose(std::size_t agent) {
    const BenchAgent& plays = agents_[agent];
    sample(agent, 0, plays.from_clip, plays.from_start);
    sample(agent, 1, plays.to_clip, plays.to_start);
    std::array<ozz::animation::BlendingJob::Layer, 2> layers;
    for (std::size_t source = 0; source < 2; ++source) layers[source].transform = ozz::make_span(locals_[source]);
    layers[0].weight = 1.0F - plays.fraction;
    layers[1].weight = plays.fraction;
    ozz::animation::BlendingJob blend;
    blend.layers = {layers.data(), layers.size()};
    blend.rest_pose = skeleton_->joint_rest_poses();
    blend.output = ozz::make_span(blended_);
    blend.Run();
    ozz::animation::LocalToModelJob to_model;
    to_model.skeleton = skeleton_.get();
    to_model.input = ozz::make_span(blended_);
    to_model.output = ozz::make_span(models_);
    to_model.Run();
    write_palette(reinterpret_cast<anim::PaletteMatrix*>(palettes_->of(agent).memory()));
  }

  void write_palette(anim::PaletteMatrix* palette) {
    for (std::size_t joint = 0; joint < models_.size(); ++joint) {
      const Float4x4 rows = ozz::math::Transpose(models_[joint] * inverse_binds_[joint]);
      auto* const out = reinterpret_cast<float*>(palette + entry_of_joint_[joint]);
      for (int row = 0; row < 3; ++row) ozz::math::StorePtr(rows.cols[row], out + 4 * row);
    }
  }

  std::span<const BenchAgent> agents_;
  const BenchPalettes* palettes_;
  anim::Ticks clock_{};
  ozz::unique_ptr<ozz::animation::Skeleton> skeleton_;
  std::vector<ozz::unique_ptr<ozz::animation::Animation>> clips_;
  std::vector<std::unique_ptr<ozz::animation::SamplingJob::Context>> contexts_;  // two an agent
  std::vector<Float4x4> inverse_binds_;                                          // [joint]
  std::vector<std::size_t> entry_of_joint_;
  ozz::vector<ozz::math::SoaTransform> locals_[2], blended_;
  ozz::vector<Float4x4> models_;
};

}  // namespace

anim::Result<std::unique_ptr<OzzSubject>> make_ozz_subject(const anim::Model& model, std::span<const BenchAgent> agents,
                                                           const BenchPalettes& palettes) {
  auto subject = std::make_unique<PlainOzzSubject>(agents, palettes);
  if (!is_plain(model) || !subject->build(model)) {
    return anim::Error{"ozz-animation is not given this model: it has matrices, scale or keys that are not LINEAR"};
  }
  return std::unique_ptr<OzzSubject>(std::move(subject));
}

}  // namespace throng::app

#else

namespace throng::app {

anim::Result<std::unique_ptr<OzzSubject>> make_ozz_subject(const anim::Model&, std::span<const BenchAgent>,
                                                           const BenchPalettes&) {
  return anim::Error{"ozz-animation was not installed when this program was built"};
}

}  // namespace throng::app

#endif
