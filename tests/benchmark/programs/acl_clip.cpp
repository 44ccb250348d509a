#ifdef THRONG_HAS_ACL

#include "tests/benchmark/programs/acl_clip.h"

#include <acl/compression/compress.h>
#include <acl/compression/track_array.h>
#include <acl/compression/transform_error_metrics.h>

namespace throng::app {
namespace {

rtm::qvvf with_scale_of_one(const LocalPlace& place) {
  const rtm::qvf unscaled = acl_place(place);
  return rtm::qvv_set(unscaled.rotation, unscaled.translation, rtm::vector_set(1.0F));
}

/// ACL keeps to its precision on a shell around each joint, at the samples. Our streams keep to the same bound on the
/// farthest vertex, which is as far off, and between the samples as well.
acl::track_desc_transformf description(const LocalBones& bones, std::size_t bone, float precision) {
  const int parent = bones.parents[bone];
  acl::track_desc_transformf result;
  result.default_value = with_scale_of_one(bones.bind_pose[bone]);
  result.output_index = static_cast<std::uint32_t>(bone);
  result.parent_index = parent < 0 ? acl::k_invalid_track_index : static_cast<std::uint32_t>(parent);
  result.precision = precision;
  result.shell_distance = bones.shells[bone];
  return result;
}

acl::track_array_qvvf raw_tracks(const LocalBones& bones, LocalClip& clip, float rate, acl::iallocator& allocator) {
  const auto bone_count = static_cast<std::uint32_t>(bones.parents.size());
  const auto samples = static_cast<std::uint32_t>(clip.samples());
  acl::track_array_qvvf tracks(allocator, bone_count);
  for (std::uint32_t bone = 0; bone < bone_count; ++bone) {
    tracks[bone] =
        acl::track_qvvf::make_reserve(description(bones, bone, clip.error_bound()), allocator, samples, rate);
  }
  for (std::uint32_t sample = 0; sample < samples; ++sample) {
    const std::span<const LocalPlace> pose = clip.pose(static_cast<int>(sample));
    for (std::uint32_t bone = 0; bone < bone_count; ++bone) tracks[bone][sample] = with_scale_of_one(pose[bone]);
  }
  return tracks;
}

}  // namespace

AclClip::~AclClip() {
  if (tracks_ != nullptr) allocator_.deallocate(tracks_, tracks_->get_size());
}

bool AclClip::compress(const anim::Skeleton& skeleton, const LocalBones& bones, const anim::BakedClip& clip) {
  LocalClip local(skeleton, clip);
  const acl::track_array_qvvf tracks = raw_tracks(bones, local, static_cast<float>(clip.sampled_rate), allocator_);
  acl::qvvf_transform_error_metric metric;
  acl::compression_settings settings = acl::get_default_compression_settings();
  settings.error_metric = &metric;
  acl::output_stats stats;
  if (acl::compress_track_list(allocator_, tracks, settings, tracks_, stats).any()) return false;
  duration_ = clip.duration;
  first_sample_ = clip.sampled()->first_row;
  return context_.initialize(*tracks_);
}

}  // namespace throng::app

#endif
