#include "engine/anim/bake/surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/base/box.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

namespace {

constexpr double least_height = 1e-6;

/// Reads one bone of a pose in double.
class BoneOfPose {
 public:
  BoneOfPose(std::span<const float> pose, int components, int bone)
      : lane_(pose.data() + static_cast<std::ptrdiff_t>(bone / packet_bones * components) * packet_bones +
              bone % packet_bones) {}
  double operator[](int component) const { return static_cast<double>(lane_[component * packet_bones]); }
  glm::dquat rotation() const { return {(*this)[3], (*this)[0], (*this)[1], (*this)[2]}; }
  glm::dvec3 vector(int first) const { return {(*this)[first], (*this)[first + 1], (*this)[first + 2]}; }

 private:
  const float* lane_;
};

/// Returns a bone's motion from the bind pose. Its rotation is relative to that pose, and offsets are vectors in it.
BoneFrame rigid_frame(const Skeleton& skeleton, int bone, const BoneOfPose& state, const BoneFrame& parent) {
  const int parent_bone = skeleton.parent(bone);
  const glm::dvec3 from =
      parent_bone < 0 ? glm::dvec3(0.0) : skeleton.references[static_cast<std::size_t>(parent_bone)].origin;
  const glm::dvec3 lever = skeleton.references[static_cast<std::size_t>(bone)].origin - from;
  return {.axes = parent.axes * glm::mat3_cast(state.rotation()),
          .origin = parent.origin + parent.axes * (lever + state.vector(4))};
}

BoneFrame general_frame(const Bone& bone, const BoneOfPose& state, const BoneFrame& parent) {
  const glm::dmat3 prefix(bone.prefix);
  const glm::dvec3 scale = state.vector(rigid_components);
  const glm::dmat3 turned = glm::mat3_cast(state.rotation());
  const glm::dmat3 local(turned[0] * scale.x, turned[1] * scale.y, turned[2] * scale.z);
  const glm::dvec3 in_parent = glm::dvec3(bone.prefix[3]) + prefix * state.vector(4);
  return {.axes = parent.axes * prefix * local, .origin = parent.origin + parent.axes * in_parent};
}

/// Returns a vertex as the offset at which the palette entry's bone carries it.
glm::dvec3 offset_from_bone(const Skeleton& skeleton, const PaletteEntry& entry, const glm::vec3& vertex) {
  const glm::dvec3 position(vertex);
  if (skeleton.rigid) return position - skeleton.references[static_cast<std::size_t>(entry.bone)].origin;
  return {entry.post * glm::dvec4(position, 1.0)};
}

template <typename Visit>
void for_each_vertex(const Model& model, const Visit& visit) {
  for (const SkinnedMesh& mesh : model.meshes) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) visit(mesh, v);
  }
}

std::vector<SurfacePoint> farthest_vertices(const Model& model) {
  std::vector<SurfacePoint> farthest;
  farthest.reserve(model.skeleton.bones.size());
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) farthest.push_back({.bone = bone});
  for_each_vertex(model, [&](const SkinnedMesh& mesh, std::size_t v) {
    const PaletteEntry& entry = model.skeleton.palette[mesh.palette_entries[v][0]];
    const glm::dvec3 offset = offset_from_bone(model.skeleton, entry, mesh.positions[v]);
    SurfacePoint& point = farthest[static_cast<std::size_t>(entry.bone)];
    if (glm::dot(offset, offset) > glm::dot(point.offset, point.offset)) point.offset = offset;
  });
  std::erase_if(farthest, [](const SurfacePoint& point) { return point.offset == glm::dvec3(0.0); });
  return farthest;
}

Box rest_box(const Model& model, std::span<const BoneFrame> frames) {
  Box box;
  for_each_vertex(model, [&](const SkinnedMesh& mesh, std::size_t v) {
    glm::dvec3 skinned(0.0);
    for (int i = 0; i < 4; ++i) {
      const PaletteEntry& entry = model.skeleton.palette[mesh.palette_entries[v][i]];
      const BoneFrame& frame = frames[static_cast<std::size_t>(entry.bone)];
      const glm::dvec3 offset = offset_from_bone(model.skeleton, entry, mesh.positions[v]);
      skinned += static_cast<double>(mesh.weights[v][i]) * (frame.origin + frame.axes * offset);
    }
    box.add(skinned);
  });
  if (box.is_empty()) std::ranges::for_each(frames, [&](const BoneFrame& frame) { box.add(frame.origin); });
  return box;
}

double rest_height(const Model& model) {
  const AlignedBytes stream = build_keyframe_stream(model.skeleton, Clip{});
  ExactPoses poses(*reinterpret_cast<const KeyframeStream*>(stream.get()));
  std::vector<BoneFrame> frames(model.skeleton.bones.size());
  compute_frames(model.skeleton, poses.at(Ticks{}), frames);
  const glm::dvec3 size = rest_box(model, frames).size();
  if (size.y > least_height) return size.y;
  return std::max({size.x, size.z, least_height});
}

}  // namespace

void compute_frames(const Skeleton& skeleton, std::span<const float> pose, std::span<BoneFrame> frames) {
  assert(frames.size() == skeleton.bones.size());
  for (int b = 0; b < skeleton.bone_count(); ++b) {
    const Bone& bone = skeleton.bones[static_cast<std::size_t>(b)];
    const BoneFrame parent = bone.parent < 0 ? BoneFrame{} : frames[static_cast<std::size_t>(bone.parent)];
    const BoneOfPose state(pose, skeleton.components(), b);
    frames[static_cast<std::size_t>(b)] =
        skeleton.rigid ? rigid_frame(skeleton, b, state, parent) : general_frame(bone, state, parent);
  }
}

SurfaceProxy make_surface_proxy(const Model& model) {
  SurfaceProxy proxy{.points = farthest_vertices(model), .height = rest_height(model)};
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) proxy.points.push_back({.bone = bone});
  return proxy;
}

double largest_distance(const SurfaceProxy& proxy, std::span<const BoneFrame> from, std::span<const BoneFrame> to) {
  double largest = 0.0;
  for (const SurfacePoint& point : proxy.points) {
    const BoneFrame& a = from[static_cast<std::size_t>(point.bone)];
    const BoneFrame& b = to[static_cast<std::size_t>(point.bone)];
    const glm::dvec3 apart = (a.origin - b.origin) + (a.axes - b.axes) * point.offset;
    largest = std::max(largest, glm::dot(apart, apart));
  }
  return std::sqrt(largest);
}

ExactPoses::ExactPoses(const KeyframeStream& stream)
    : stream_(stream),
      interpolations_(allocate_aligned(interpolation_bytes(stream.bone_count, stream.components))),
      pose_(allocate_aligned(pose_bytes(stream.bone_count, stream.components))) {}

std::span<float> ExactPoses::at(Ticks time) {
  const std::span interpolations(interpolations_.get(), interpolation_bytes(stream_.bone_count, stream_.components));
  const std::size_t packet_floats = static_cast<std::size_t>(stream_.components) * packet_bones;
  const std::span pose(reinterpret_cast<float*>(pose_.get()),
                       packet_floats * static_cast<std::size_t>(packets_for(stream_.bone_count)));
  advance_keyframes(stream_, time, cursor_, interpolations);
  for (int packet = 0; packet < packets_for(stream_.bone_count); ++packet) {
    evaluate_keyframes(stream_, time, interpolations, packet,
                       pose.subspan(static_cast<std::size_t>(packet) * packet_floats, packet_floats));
  }
  return pose;
}

SampledPoses::SampledPoses(const SampledStream& stream)
    : stream_(stream), pose_(allocate_aligned(pose_bytes(stream.bone_count, stream.components))) {}

std::span<const float> SampledPoses::at(const SamplePoint& point) {
  auto* const pose = reinterpret_cast<float*>(pose_.get());
  for (int packet = 0; packet < stream_.packet_count(); ++packet) {
    float* const out = pose + static_cast<std::ptrdiff_t>(packet) * stream_.components * packet_bones;
    best_kernels().sample({.stream = &stream_, .point = point, .packet = packet, .pose = out});
  }
  return {pose, pose_bytes(stream_.bone_count, stream_.components) / sizeof(float)};
}

ClipPoses::ClipPoses(const KeyframeStream* keys, const SampledStream* rows) : stream_(rows) {
  if (keys != nullptr) {
    keys_.emplace(*keys);
  } else {
    rows_.emplace(*rows);
  }
}

}  // namespace throng::anim
