#include "tests/benchmark/programs/ozz_subject.h"

#ifdef THRONG_HAS_OZZ

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <ozz/animation/offline/animation_builder.h>
#include <ozz/animation/offline/animation_optimizer.h>
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

#include "tests/benchmark/programs/local_poses.h"

namespace throng::app {
namespace {

using ozz::math::Float3;
using ozz::math::Float4x4;
using ozz::math::Quaternion;

Float3 of(const glm::vec3& v) { return {v.x, v.y, v.z}; }
Quaternion of(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

/// Joints are named after our bones, because ozz puts them in an order of its own.
ozz::animation::offline::RawSkeleton::Joint raw_joint(const LocalBones& bones, std::size_t bone) {
  ozz::animation::offline::RawSkeleton::Joint joint;
  joint.name = std::to_string(bone).c_str();
  joint.transform.translation = of(bones.bind_pose[bone].position);
  joint.transform.rotation = of(bones.bind_pose[bone].rotation);
  joint.transform.scale = Float3::one();
  for (std::size_t child = bone + 1; child < bones.parents.size(); ++child) {
    if (bones.parents[child] == static_cast<int>(bone)) joint.children.push_back(raw_joint(bones, child));
  }
  return joint;
}

ozz::animation::offline::RawSkeleton raw_skeleton(const LocalBones& bones) {
  ozz::animation::offline::RawSkeleton raw;
  for (std::size_t bone = 0; bone < bones.parents.size(); ++bone) {
    if (bones.parents[bone] < 0) raw.roots.push_back(raw_joint(bones, bone));
  }
  return raw;
}

ozz::animation::offline::RawAnimation raw_animation(LocalClip& clip, Ticks duration,
                                                    const std::vector<std::size_t>& joint_of_bone) {
  ozz::animation::offline::RawAnimation raw;
  raw.duration = static_cast<float>(to_seconds(std::max(duration, Ticks{1})));
  raw.tracks.resize(joint_of_bone.size());
  for (int sample = 0; sample < clip.samples(); ++sample) {
    const auto time = static_cast<float>(to_seconds(clip.time_of(sample)));
    const std::span<const LocalPlace> pose = clip.pose(sample);
    for (std::size_t bone = 0; bone < pose.size(); ++bone) {
      auto& track = raw.tracks[joint_of_bone[bone]];
      track.translations.push_back({time, of(pose[bone].position)});
      track.rotations.push_back({time, of(pose[bone].rotation)});
    }
  }
  return raw;
}

Float4x4 matrix_of(const LocalPlace& place) {
  const auto load = [](const glm::vec3& v, float w) { return ozz::math::simd_float4::Load(v.x, v.y, v.z, w); };
  const glm::mat3 axes = glm::mat3_cast(place.rotation);
  return {{load(axes[0], 0.0F), load(axes[1], 0.0F), load(axes[2], 0.0F), load(place.position, 1.0F)}};
}

class OzzSubject final : public LibrarySubject {
 public:
  OzzSubject(std::span<const BenchAgent> agents, const BenchPalettes& palettes) : LibrarySubject(agents, palettes) {}

  bool build(const BenchCharacter& whom) {
    const LocalBones bones = local_bones(whom.model);
    const ozz::animation::offline::RawSkeleton raw = raw_skeleton(bones);
    if (!raw.Validate()) return false;
    skeleton_ = ozz::animation::offline::SkeletonBuilder()(raw);
    joint_of_bone_.resize(bones.parents.size());
    ozz::animation::offline::AnimationOptimizer optimizer;
    for (int joint = 0; joint < skeleton_->num_joints(); ++joint) {
      const auto bone = static_cast<std::size_t>(std::stoi(skeleton_->joint_names()[static_cast<std::size_t>(joint)]));
      joint_of_bone_[bone] = static_cast<std::size_t>(joint);
      entry_of_joint_.push_back(bone);
      inverse_binds_.push_back(matrix_of(bones.inverse_binds[bone]));
      optimizer.joints_setting_override[joint].distance = bones.shells[bone];
    }
    for (const anim::BakedClip& clip : whom.character->clips) {
      LocalClip local(whom.model.skeleton, clip);
      if (!add_clip(local, clip.duration, optimizer)) return false;
    }
    make_buffers();
    return true;
  }

  std::size_t bytes() const override {
    std::size_t sum = 0;
    for (const auto& clip : clips_) sum += clip->size();
    return sum;
  }

 private:
  /// The optimizer leaves out keys as far as our own bound allows.
  bool add_clip(LocalClip& clip, Ticks duration, ozz::animation::offline::AnimationOptimizer& optimizer) {
    optimizer.setting.tolerance = clip.error_bound();
    for (auto& [joint, setting] : optimizer.joints_setting_override) setting.tolerance = clip.error_bound();
    ozz::animation::offline::RawAnimation optimized;
    if (!optimizer(raw_animation(clip, duration, joint_of_bone_), *skeleton_, &optimized)) return false;
    clips_.push_back(ozz::animation::offline::AnimationBuilder()(optimized));
    return clips_.back() != nullptr;
  }

  void make_buffers() {
    const auto soa = static_cast<std::size_t>(skeleton_->num_soa_joints());
    for (auto& locals : locals_) locals.resize(soa);
    blended_.resize(soa);
    models_.resize(static_cast<std::size_t>(skeleton_->num_joints()));
    for (std::size_t i = 0; i < 2 * agents().size(); ++i) {
      contexts_.push_back(std::make_unique<ozz::animation::SamplingJob::Context>(skeleton_->num_joints()));
    }
  }

  void sample(std::size_t agent, std::size_t source, int clip, Ticks start) {
    const ozz::animation::Animation& animation = *clips_[static_cast<std::size_t>(clip)];
    const Ticks duration = to_ticks(static_cast<double>(animation.duration()));
    ozz::animation::SamplingJob job;
    job.animation = &animation;
    job.context = contexts_[2 * agent + source].get();
    job.ratio = static_cast<float>(to_seconds(time_in_clip(start, duration)) / to_seconds(duration));
    job.output = ozz::make_span(locals_[source]);
    job.Run();
  }

  void pose(std::size_t agent) override {
    const BenchAgent& plays = agents()[agent];
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
    write_palette(palette_of(agent));
  }

  void write_palette(anim::PaletteMatrix* palette) {
    for (std::size_t joint = 0; joint < models_.size(); ++joint) {
      const Float4x4 rows = ozz::math::Transpose(models_[joint] * inverse_binds_[joint]);
      auto* const out = reinterpret_cast<float*>(palette + entry_of_joint_[joint]);
      for (int row = 0; row < 3; ++row) ozz::math::StorePtr(rows.cols[row], out + 4 * row);
    }
  }

  ozz::unique_ptr<ozz::animation::Skeleton> skeleton_;
  std::vector<ozz::unique_ptr<ozz::animation::Animation>> clips_;
  std::vector<std::unique_ptr<ozz::animation::SamplingJob::Context>> contexts_;  // two an agent
  std::vector<Float4x4> inverse_binds_;                                          // [joint]
  std::vector<std::size_t> joint_of_bone_, entry_of_joint_;
  ozz::vector<ozz::math::SoaTransform> locals_[2], blended_;
  ozz::vector<Float4x4> models_;
};

}  // namespace

Result<std::unique_ptr<LibrarySubject>> make_ozz_subject(const BenchCharacter& whom, std::span<const BenchAgent> agents,
                                                         const BenchPalettes& palettes) {
  const Status sampled = has_local_clips(*whom.character);
  if (!sampled) return sampled.error();
  auto subject = std::make_unique<OzzSubject>(agents, palettes);
  if (!subject->build(whom)) return Error{"it does not take this model"};
  return std::unique_ptr<LibrarySubject>(std::move(subject));
}

}  // namespace throng::app

#else

namespace throng::app {

Result<std::unique_ptr<LibrarySubject>> make_ozz_subject(const BenchCharacter&, std::span<const BenchAgent>,
                                                         const BenchPalettes&) {
  return Error{"it was not installed when this program was built"};
}

}  // namespace throng::app

#endif
